#pragma once

#include "rheometry/fit/least_squares.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// An interval in the search's coordinates.
struct ProfileInterval {
    double low{};
    double high{};
    bool low_reached = true;    ///< false: `low` is the parameter's bound, and still within
    bool high_reached = true;   ///< the same for `high`
    std::vector<double> at_low; ///< all parameters where the interval ends
    std::vector<double> at_high;
    /// A better optimum that was met on the way; the interval is then void.
    std::optional<Minimum> better;
};

/// Values of one parameter for which the sum of squares, minimised over all others, stays within
/// variance * quantile^2 of the minimum. Exact in the limit of many points whatever the curvature;
/// independent of how the parameter is written.
/// @param variance   of one residual
/// @param quantile   e.g. 95 % of Student's t
/// @param covariance inverse normal matrix times variance, for first guesses; may be empty
[[nodiscard]] ProfileInterval profile_interval(const LeastSquaresProblem& problem,
                                               const Minimum& minimum, std::size_t index,
                                               double variance, double quantile,
                                               std::span<const double> covariance);

} // namespace searle::rheometry::fit
