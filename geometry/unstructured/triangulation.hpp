#pragma once

#include "geometry/mesh_settings.hpp"
#include "geometry/outline.hpp"

#include <vector>

namespace searle::geometry {

/// Cell sizes of a triangulation. At a point of the fluid they are the local width (distance to the
/// rotor plus distance to what stands still) over `across`, no more than `largest`, and finer
/// towards re-entrant corners.
struct TriangleSizes {
    double across = 10; ///< cells across the local width
    double largest{};   ///< m
    double fixed{};     ///< m, > 0: all cells have this size instead
    double growth = 1.2;
};

/// False: gmsh is not here.
[[nodiscard]] bool can_triangulate();

/// Triangles that fill the outlines, as a plane mesh with their patches. Made by gmsh.
/// Throws MeshError when gmsh fails or there would be more than `most_cells`, MeshToolMissing when
/// gmsh is not here.
[[nodiscard]] Mesh triangulated(const std::vector<Outline>& outlines, const TriangleSizes& sizes,
                                std::int64_t most_cells);

} // namespace searle::geometry
