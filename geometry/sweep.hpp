#pragma once

#include "geometry/mesh.hpp"

namespace searle::geometry {

/// How a plane section becomes a solid mesh.
struct Sweep {
    enum class Ends {
        wedge,    ///< patches wedge_front and wedge_back, for a wedge one cell thick
        periodic, ///< patches periodic_front and periodic_back, each the other's partner
        closed    ///< the last layer is the first: a full turn
    };

    bool revolved = true; ///< about the z axis; false: drawn out along x
    double extent{};      ///< rad, or m along x; > 0
    int cells = 1;        ///< in the sweep's direction, >= 1; a closed sweep has >= 3
    Ends ends = Ends::wedge;
    double radius_factor = 1.0; ///< on every radius, see VertexRadius
};

/// Sweeps a section of straight-edged plane cells: about the axis from -extent/2 to extent/2 (a
/// closed sweep: from 0), or along x from 0 to extent. Points at r = 0 stay one point, cells that
/// touch the axis become prisms, pyramids and tetrahedra; the patch "axis" has no faces any more.
[[nodiscard]] Mesh swept(const Mesh& section, const Sweep& sweep);

/// Each quadrangle with exactly one corner on the axis in two triangles; the rest as it is.
[[nodiscard]] Mesh with_triangles_at_axis_corners(const Mesh& section);

/// Which middles of edges lie on arcs about the axis; the others are half way.
enum class CurvedEdges {
    none,
    walls, ///< those of faces of walls and free surfaces
    all    ///< for a swept mesh, so that cylinders and cones are met in every node
};

/// The same cells with a node in the middle of each edge.
[[nodiscard]] Mesh second_order(const Mesh& mesh, CurvedEdges curved);

} // namespace searle::geometry
