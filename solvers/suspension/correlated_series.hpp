#pragma once

#include <cstddef>
#include <span>

namespace searle::solvers::suspension {

/// The mean; 0 of nothing.
[[nodiscard]] double plain_mean(std::span<const double> values);

/// Value at `at` of the straight line of least squares through values at places x.
[[nodiscard]] double value_on_line(std::span<const double> x, std::span<const double> values,
                                   double at);

/// What a series of equally spaced, correlated values says about its expectation.
struct SeriesEstimate {
    double value{};
    /// Half of the distance that holds the truth with a probability of 95.45 %: of a long series
    /// one standard error; of a short one larger, so that twice the error still holds it.
    /// Infinite for fewer than `fewest_values`; 0 when all values are on the line.
    double error{};
    /// How many independent values would tell as much; at most about 15, as the series is looked
    /// at in at most `most_blocks` pieces. Below `enough_independent` (an AR(1) process over less
    /// than about 16 correlation times) the error is mostly what long correlations allow.
    double independent{};
};

inline constexpr std::size_t fewest_values = 8;
inline constexpr std::size_t most_blocks = 32;
inline constexpr double enough_independent = 3.0;

/// Mean and its error.
///
/// The correlation is not known beforehand, and a short series tells it badly; taking its most
/// likely value gives errors that are too small. So every correlation of a family is weighed with
/// how well it explains the series (Bayes), and the error is that of all of them together:
/// white noise (half of the prior), or a process of correlation time 1/64 to 1 of the series'
/// length (evenly in its logarithm), exponential as AR(1) or of a smooth path (Matern 3/2), with
/// white noise of 0 to 90 % beside it. For each of them the mean has exactly Student's t
/// distribution. Correlations longer than the series cannot be seen by any means.
[[nodiscard]] SeriesEstimate mean_of_series(std::span<const double> values);

/// The same of a straight line through values at equally spaced places x, at the place `at`.
[[nodiscard]] SeriesEstimate line_at(std::span<const double> x, std::span<const double> values,
                                     double at);

} // namespace searle::solvers::suspension
