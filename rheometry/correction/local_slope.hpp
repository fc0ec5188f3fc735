#pragma once

#include <span>
#include <vector>

namespace searle::rheometry {

/// A smooth curve through scattered points, at one of them.
struct LocalSlope {
    double value{};                ///< of the curve
    double slope{};                ///< dy/dx
    double slope_standard_error{}; ///< one standard error, from the scatter
    double curvature{};            ///< d2y/dx2
    double curvature_standard_error{};
    std::size_t window{}; ///< points that the slope rests on
};

/// Value, slope and curvature of y(x) at each x, by local least squares with Epanechnikov weights.
/// Windows hold 5 points or more and are grown as long as the confidence intervals for the slope of
/// a quadratic over all smaller windows still share a point (the intersection rule of Goldenshluger
/// and Nemirovski 1997, Math. Methods Statist. 6, 135). What is returned comes from a cubic over
/// that window, whose own bias is small beside its standard error (bias correction after Calonico,
/// Cattaneo and Farrell 2018, J. Am. Stat. Assoc. 113, 767); half of the squared difference of the
/// two slopes is added to the variance, since the data also chose the window. At the ends the
/// windows are one-sided and the standard errors larger. NaN where points lie so that no cubic is
/// determined.
/// @param x        strictly increasing, 5 or more
/// @param y        as many
/// @param weights  number of measurements behind each point, > 0, as many
[[nodiscard]] std::vector<LocalSlope>
local_slopes(std::span<const double> x, std::span<const double> y, std::span<const double> weights);

} // namespace searle::rheometry
