#pragma once

#include "geometry/mesh.hpp"

namespace searle::geometry {

struct SurfaceMeasures {
    double area{};   ///< m^2
    double volume{}; ///< m^3, its share of the enclosed volume: a third of the flux of the position
};

/// Area of a patch of curved or straight faces, and what it adds to the volume that all patches
/// enclose. Gauss quadrature, exact to rounding for straight triangles.
[[nodiscard]] SurfaceMeasures surface_measures_of(const Mesh& mesh, const Patch& patch);

} // namespace searle::geometry
