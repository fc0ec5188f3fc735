#pragma once

#include <vector>

namespace searle::solvers::radial {

/// Cross-section of a gap for the transient equation rho m dw/dt = dF/dx, dw/dx = rate(F/a)/b:
///  - annulus: x = r, w the angular velocity, F = r^2 tau, m = r^3, a = r^2, b = r;
///  - planar (box): x the distance from the moving wall, w the velocity, F = tau, m = a = b = 1.
struct GapShape {
    bool planar{};
    double inner{}; ///< x of the inner wall, m
    double outer{}; ///< x of the outer wall, m
    bool outer_wall_moves{};
    double density{}; ///< kg/m^3

    [[nodiscard]] double width() const { return outer - inner; }
};

/// Element boundaries from the inner to the outer wall, geometrically graded to the moving wall.
/// @param layer  thickness of the momentum layer that the first rows see, m; where it is thinner
///               than the gap, a quarter of the elements' parameter range lies within about it
/// @param elements  number of elements; doubling it halves every element of the same map
[[nodiscard]] std::vector<double> graded_grid(const GapShape& shape, double layer, int elements);

} // namespace searle::solvers::radial
