#pragma once

#include <cstddef>
#include <span>

namespace searle::solvers::suspension {

/// Mean of a series that is correlated, and its standard error.
struct SeriesMean {
    double mean{};
    double standard_error{}; ///< infinite for fewer than 8 values
    /// Correlation as the number of neighbouring values that count as one, >= 1.
    double inefficiency = 1.0;
};

/// Standard error by blocking (Flyvbjerg & Petersen 1989, J. Chem. Phys. 91, 461): neighbours are
/// averaged pair by pair until the error of the mean of what is left no longer grows; the largest
/// error of the levels with at least 8 blocks is taken.
[[nodiscard]] SeriesMean mean_of_series(std::span<const double> values);

/// How many values at the start are not yet those of the steady state: the truncation with the
/// smallest marginal standard error (White 1997, Simulation 69, 323), found on means of five
/// values; at most half of the series.
[[nodiscard]] std::size_t start_up_length(std::span<const double> values);

/// Straight line through values at places x, and its value with standard error at `at`.
struct LineFit {
    double value{};
    double standard_error{}; ///< from the scatter about the line, correlation included
};
[[nodiscard]] LineFit line_at(std::span<const double> x, std::span<const double> values, double at);

} // namespace searle::solvers::suspension
