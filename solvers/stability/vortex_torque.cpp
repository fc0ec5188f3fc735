#include "solvers/stability/vortex_torque.hpp"

#include "solvers/stability/taylor_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::solvers::stability {

double vortex_torque_ratio(double relative_gap, double ratio) {
    if (!(ratio > 1.0))
        return 1.0;
    const double weak = 1.0 + 1.5 * (1.0 - 1.0 / (ratio * ratio));
    const double reynolds = ratio * taylor_threshold(relative_gap).reynolds;
    const double eta = 1.0 / (1.0 + relative_gap);
    const double measured =
        std::max(1.45 * std::pow(reynolds, 1.5), 0.23 * std::pow(reynolds, 1.7)) *
        std::pow(eta, 1.5) / std::pow(1.0 - eta, 1.75);
    const double laminar =
        4.0 * std::numbers::pi * eta / ((1.0 + eta) * std::pow(1.0 - eta, 2)) * reynolds;
    return std::max(weak, measured / laminar);
}

} // namespace searle::solvers::stability
