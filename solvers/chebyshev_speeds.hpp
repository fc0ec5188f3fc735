#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace searle::solvers {

/// Chebyshev point k = 0 ... degree of the second kind in ln speed, rising from `low` to `high`,
/// both logarithms of speeds.
[[nodiscard]] inline double chebyshev_speed(double low, double high, int k, int degree) {
    return std::exp(0.5 * (low + high) -
                    0.5 * (high - low) * std::cos(std::numbers::pi * k / degree));
}

/// Barycentric formula for the logarithm of a value known at all Chebyshev points of one degree, in
/// ln speed; the value itself at a point.
/// @param speed_of, value_of  speed and value > 0 of an element of `points`, which are by rising
///                            speed
template <class Points, class SpeedOf, class ValueOf>
[[nodiscard]] double interpolated_in_log(const Points& points, double speed,
                                         const SpeedOf& speed_of, const ValueOf& value_of) {
    double above = 0.0;
    double below = 0.0;
    std::size_t k = 0;
    for (const auto& point : points) {
        const double distance = std::log(speed / speed_of(point));
        if (std::abs(distance) < 1e-13) {
            return value_of(point);
        }
        const bool at_end = k == 0 || k + 1 == points.size();
        const double weight = (k % 2 == 0 ? 1.0 : -1.0) * (at_end ? 0.5 : 1.0) / distance;
        above += weight * std::log(value_of(point));
        below += weight;
        ++k;
    }
    return std::exp(above / below);
}

} // namespace searle::solvers
