#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace searle::geometry {

struct Sphere {
    double x{}, y{}, z{};
    double radius{};
};

/// Cells of the power diagram (Laguerre or radical Voronoi diagram; Voronoi's own for equal radii):
/// of each sphere the points whose |x - centre|^2 - radius^2 is least with it. Spheres that do not
/// overlap lie inside of their cells.
struct PowerCells {
    /// In the units of the spheres, cubed; 0 of a sphere whose cell others cover, infinite of a
    /// cell that others do not close.
    std::vector<double> volume;
    /// No sphere further than this from a cell's own, by its centre, could change it.
    double reach{};
};

/// The cells of the first `count` spheres among all of them, from the regular triangulation (exact
/// predicates, so that lattices are no special case).
[[nodiscard]] PowerCells power_cells(std::span<const Sphere> spheres, std::size_t count);

} // namespace searle::geometry
