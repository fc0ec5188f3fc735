#include "geometry/sweep.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace searle::geometry {
namespace {

using Node = std::uint32_t;

/// Triangles of a face: a quadrangle is cut at its corner with the lowest number.
template <class Use>
void for_each_triangle(std::span<const Node> corners, Use use) {
    if (corners.size() == 3) {
        use(std::array{corners[0], corners[1], corners[2]});
        return;
    }
    const auto lowest = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) -
                                                 corners.begin());
    const auto corner = [&](std::size_t after) { return corners[(lowest + after) % 4]; };
    use(std::array{corner(0), corner(1), corner(2)});
    use(std::array{corner(0), corner(2), corner(3)});
}

/// Joins the corner with the lowest number to the triangles of the faces that do not touch it.
void split_cell(CellShape shape, std::span<const Node> corners, ElementList& cells) {
    if (shape == CellShape::tetrahedron4) {
        cells.add(shape, corners);
        return;
    }
    if (shape == CellShape::hexahedron8)
        throw std::logic_error("hexahedra are not split into tetrahedra");
    const Node apex = *std::min_element(corners.begin(), corners.end());
    for (const LocalFace& face : faces_of(shape)) {
        std::vector<Node> nodes;
        for (const std::int8_t at : face)
            if (at >= 0)
                nodes.push_back(corners[static_cast<std::size_t>(at)]);
        if (std::find(nodes.begin(), nodes.end(), apex) != nodes.end())
            continue;
        for_each_triangle(nodes, [&](const std::array<Node, 3>& triangle) {
            // The face looks out of the cell, a base looks into it.
            cells.add(CellShape::tetrahedron4,
                      std::array{triangle[0], triangle[2], triangle[1], apex});
        });
    }
}

} // namespace

Mesh split_into_tetrahedra(const Mesh& mesh) {
    Mesh result;
    result.dimension = mesh.dimension;
    result.points = mesh.points;
    result.periodic_points = mesh.periodic_points;
    result.periodic_map = mesh.periodic_map;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        split_cell(mesh.cells.shape(cell), mesh.cells.corners(cell), result.cells);
    for (const Patch& patch : mesh.patches) {
        Patch split = patch;
        split.first = result.faces.size();
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face)
            for_each_triangle(mesh.faces.corners(face), [&](const std::array<Node, 3>& triangle) {
                result.faces.add(CellShape::triangle3, triangle);
            });
        split.count = result.faces.size() - split.first;
        result.patches.push_back(std::move(split));
    }
    return result;
}

} // namespace searle::geometry
