#pragma once

#include "geometry/mesh.hpp"

namespace searle::geometry {

/// Gmsh's number of an element type; its nodes are in our order.
[[nodiscard]] constexpr int gmsh_type(CellShape shape) {
    switch (shape) {
    case CellShape::line2:
        return 1;
    case CellShape::triangle3:
        return 2;
    case CellShape::quadrangle4:
        return 3;
    case CellShape::tetrahedron4:
        return 4;
    case CellShape::hexahedron8:
        return 5;
    case CellShape::prism6:
        return 6;
    case CellShape::pyramid5:
        return 7;
    case CellShape::line3:
        return 8;
    case CellShape::triangle6:
        return 9;
    case CellShape::tetrahedron10:
        return 11;
    case CellShape::quadrangle8:
        return 16;
    case CellShape::hexahedron20:
        return 17;
    case CellShape::prism15:
        return 18;
    case CellShape::pyramid13:
        return 19;
    }
    return 0;
}

} // namespace searle::geometry
