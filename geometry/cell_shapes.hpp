#pragma once

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"

#include <vector>

namespace searle::geometry {

struct FaceGeometry {
    Point centre; ///< m
    Point area;   ///< along the normal, m^2
};

/// Centre and area of a straight-edged face: the mean over its triangles about its middle.
[[nodiscard]] FaceGeometry face_geometry(const Mesh& mesh, const MeshFace& face);

struct CellGeometry {
    std::vector<Point> centres;   ///< m
    std::vector<double> volumes;  ///< m^3
    std::vector<double> openness; ///< |sum of face areas| / sum of |face areas|
};

[[nodiscard]] CellGeometry cell_geometry(const Mesh& mesh, const MeshFaces& faces);

/// Least determinant of the three unit edges that meet in a corner, over the corners (of a
/// pyramid's apex the best three); 1 for a cuboid, negative for a folded cell.
[[nodiscard]] double scaled_jacobian(const Mesh& mesh, std::size_t cell);

/// Longest over shortest edge.
[[nodiscard]] double aspect_ratio(const Mesh& mesh, std::size_t cell);

} // namespace searle::geometry
