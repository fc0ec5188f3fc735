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

/// Prisms, pyramids and tetrahedra in tetrahedra, so that neighbours agree on the diagonal of the
/// face between them (it starts at the corner with the lowest number). No hexahedra.
[[nodiscard]] Mesh split_into_tetrahedra(const Mesh& mesh);

/// The same cells with a node in the middle of each edge; in a swept mesh about the axis
/// (`revolved`) on the arc, so that cylinders and cones are met in every node.
[[nodiscard]] Mesh second_order(const Mesh& mesh, bool revolved);

} // namespace searle::geometry
