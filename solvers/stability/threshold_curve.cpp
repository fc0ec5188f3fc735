#include "solvers/stability/threshold_curve.hpp"

#include "solvers/stability/taylor_threshold.hpp"

#include <cmath>
#include <numbers>

namespace searle::solvers::stability {

ThresholdCurve::ThresholdCurve(double widest_relative_gap) {
    const double widest = std::log1p(widest_relative_gap);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / count;
        nodes_[i] = 0.5 * widest * (1.0 - std::cos(angle));
        const double relative_gap = std::expm1(nodes_[i]);
        values_[i] = std::log(taylor_threshold(relative_gap).reynolds * std::sqrt(relative_gap));
    }
}

double ThresholdCurve::critical_reynolds(double relative_gap) const {
    const double position = std::log1p(relative_gap);
    double above = 0.0;
    double below = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double distance = position - nodes_[i];
        if (distance == 0.0) {
            return std::exp(values_[i]) / std::sqrt(relative_gap);
        }
        // Barycentric weights of Chebyshev points of the first kind.
        const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / count;
        const double weight = (i % 2 == 0 ? 1.0 : -1.0) * std::sin(angle) / distance;
        above += weight * values_[i];
        below += weight;
    }
    return std::exp(above / below) / std::sqrt(relative_gap);
}

} // namespace searle::solvers::stability
