#pragma once

#include "geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace searle::geometry {

/// A straight-edged face of the solid cells. Its normal leaves `owner`, the cell with the lower
/// number, towards `neighbour`, or out of the fluid.
struct MeshFace {
    static constexpr std::uint32_t none = 0xffffffff;

    std::array<std::uint32_t, 4> corners{none, none, none, none}; ///< the last: none in a triangle
    std::uint32_t owner = none;
    std::uint32_t neighbour = none;

    [[nodiscard]] std::size_t corner_count() const { return corners[3] == none ? 3 : 4; }
};

/// All faces of a solid mesh: those inside, ordered by owner and then by neighbour, and those of
/// the boundary in the order of Mesh::faces.
struct MeshFaces {
    std::vector<MeshFace> inside;
    std::vector<MeshFace> boundary;
    /// Faces of cells that no other cell and no patch shares, and patch faces without a cell; 0 in
    /// a mesh that is closed.
    std::size_t unmatched{};
    /// Patch faces that look into the fluid, and inner faces that both cells see from the same
    /// side; 0 in a mesh that is oriented.
    std::size_t misoriented{};
};

/// Finds what the cells share. Time and memory grow with the number of cells.
[[nodiscard]] MeshFaces faces_of_cells(const Mesh& mesh);

} // namespace searle::geometry
