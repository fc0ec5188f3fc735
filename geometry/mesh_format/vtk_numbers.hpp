#pragma once

#include "geometry/mesh.hpp"

#include <vector>

namespace searle::geometry {

/// VTK's number of a cell type.
[[nodiscard]] constexpr int vtk_type(CellShape shape) {
    switch (shape) {
    case CellShape::line2:
        return 3;
    case CellShape::triangle3:
        return 5;
    case CellShape::quadrangle4:
        return 9;
    case CellShape::tetrahedron4:
        return 10;
    case CellShape::hexahedron8:
        return 12;
    case CellShape::prism6:
        return 13;
    case CellShape::pyramid5:
        return 14;
    case CellShape::line3:
        return 21;
    case CellShape::triangle6:
        return 22;
    case CellShape::quadrangle8:
        return 23;
    case CellShape::tetrahedron10:
        return 24;
    case CellShape::hexahedron20:
        return 25;
    case CellShape::prism15:
        return 26;
    case CellShape::pyramid13:
        return 27;
    }
    return 0;
}

/// A cell's nodes in VTK's order: it numbers the middles of edges base, top, uprights, and the base
/// of a straight prism the other way round.
[[nodiscard]] std::vector<std::uint32_t> vtk_nodes(CellShape shape,
                                                   std::span<const std::uint32_t> nodes);

/// Cells and then faces, each with the number of its patch: 0 for the fluid, n for the n-th patch.
template <class Use>
void for_each_vtk_cell(const Mesh& mesh, Use use) {
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        use(mesh.cells.shape(cell), mesh.cells.nodes(cell), 0);
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        for (std::size_t face = 0; face < mesh.patches[patch].count; ++face) {
            const std::size_t at = mesh.patches[patch].first + face;
            use(mesh.faces.shape(at), mesh.faces.nodes(at), static_cast<int>(patch) + 1);
        }
}

} // namespace searle::geometry
