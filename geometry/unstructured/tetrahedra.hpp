#pragma once

#include "geometry/unstructured/triangulation.hpp"

namespace searle::geometry {

/// The solid that a section sweeps: about the z axis from -extent/2, or along x from extent to 0.
struct SolidExtent {
    bool revolved = true;
    double extent{};     ///< rad, or m along x
    bool closed = false; ///< a full turn; otherwise the ends are a periodic pair
};

/// Tetrahedra of the same sizes as the triangles would have, as wide around the axis as in the
/// section. Vertices of the walls lie on the true surfaces. Made by gmsh.
/// Throws as triangulated does.
[[nodiscard]] Mesh filled_with_tetrahedra(const std::vector<Outline>& outlines,
                                          const TriangleSizes& sizes, const SolidExtent& solid,
                                          std::int64_t most_cells);

} // namespace searle::geometry
