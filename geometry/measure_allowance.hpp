#pragma once

#include "geometry/mesh_build.hpp"

#include <map>
#include <string>

namespace searle::geometry {

/// How far a mesh may be from BuiltMesh::expected where that is no closed form of the very cells;
/// zero where it is.
struct MeasureAllowance {
    double volume{};                     ///< m^3
    std::map<std::string, double> areas; ///< m^2, by patch
};

/// Tetrahedra have chords of all directions: between a face and its wall there is at most the
/// face's area times its sagitta, radius (1 - cos(half its angle)), and beside each edge on a
/// circle at most the edge's length times its own. Swept cells of second order differ in the area
/// of the triangles that end on the axis: at most by what lies between chord and parabola.
[[nodiscard]] MeasureAllowance measure_allowance(const BuiltMesh& built);

} // namespace searle::geometry
