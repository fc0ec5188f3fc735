#include "solvers/stability/threshold_curve.hpp"

#include "solvers/stability/taylor_threshold.hpp"

#include <cmath>
#include <numbers>

namespace searle::solvers::stability {

namespace {

constexpr double narrow = 0.1;

/// Points that keep the interpolation's error below 1e-8 up to relative gaps of 0.6.
std::size_t points_for(double widest_relative_gap) {
    return widest_relative_gap <= narrow ? 4 : widest_relative_gap <= 0.6 ? 6 : 9;
}

/// Angle of a Chebyshev point of the first kind.
double angle_of(std::size_t point, std::size_t count) {
    return std::numbers::pi * (static_cast<double>(point) + 0.5) / static_cast<double>(count);
}

} // namespace

ThresholdCurve::ThresholdCurve(double widest_relative_gap) {
    // In a narrow gap 16 modes have 12 digits already, and need no second resolution beside them.
    constexpr int modes_of_narrow = 16;
    const double widest = std::log1p(widest_relative_gap);
    const std::size_t count = points_for(widest_relative_gap);
    for (std::size_t i = 0; i < count; ++i) {
        nodes_.push_back(0.5 * widest * (1.0 - std::cos(angle_of(i, count))));
        const double relative_gap = std::expm1(nodes_.back());
        const double reynolds =
            widest_relative_gap <= narrow
                ? taylor_threshold_with_modes(relative_gap, modes_of_narrow).reynolds
                : taylor_threshold(relative_gap).reynolds;
        values_.push_back(std::log(reynolds * std::sqrt(relative_gap)));
    }
}

double ThresholdCurve::critical_reynolds(double relative_gap) const {
    const double position = std::log1p(relative_gap);
    double above = 0.0;
    double below = 0.0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const double distance = position - nodes_[i];
        if (distance == 0.0) {
            return std::exp(values_[i]) / std::sqrt(relative_gap);
        }
        // Barycentric weights of Chebyshev points of the first kind.
        const double weight =
            (i % 2 == 0 ? 1.0 : -1.0) * std::sin(angle_of(i, nodes_.size())) / distance;
        above += weight * values_[i];
        below += weight;
    }
    return std::exp(above / below) / std::sqrt(relative_gap);
}

} // namespace searle::solvers::stability
