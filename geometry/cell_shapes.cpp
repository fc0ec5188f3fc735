#include "geometry/cell_shapes.hpp"

#include "geometry/vector3.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace searle::geometry {
namespace {

/// A corner and the three that it is joined to, in right-handed order.
using Trihedron = std::array<std::int8_t, 4>;

constexpr std::array<Trihedron, 4> tetrahedron_corners{
    {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
constexpr std::array<Trihedron, 4> pyramid_corners{
    {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}}};
constexpr std::array<Trihedron, 6> prism_corners{
    {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}}};
constexpr std::array<Trihedron, 8> hexahedron_corners{{{0, 1, 3, 4},
                                                       {1, 2, 0, 5},
                                                       {2, 3, 1, 6},
                                                       {3, 0, 2, 7},
                                                       {4, 7, 5, 0},
                                                       {5, 4, 6, 1},
                                                       {6, 5, 7, 2},
                                                       {7, 6, 4, 3}}};

std::span<const Trihedron> corners_of(CellShape shape) {
    switch (straight(shape)) {
    case CellShape::tetrahedron4:
        return tetrahedron_corners;
    case CellShape::pyramid5:
        return pyramid_corners;
    case CellShape::prism6:
        return prism_corners;
    case CellShape::hexahedron8:
        return hexahedron_corners;
    default:
        return {};
    }
}

/// Of an equilateral corner, so that the best cell of each shape has 1.
double best_of(CellShape shape) {
    switch (straight(shape)) {
    case CellShape::tetrahedron4:
        return 0.70710678118654752; // regular tetrahedron
    case CellShape::prism6:
        return 0.86602540378443865; // equilateral, upright
    case CellShape::pyramid5:
        return 0.70710678118654752; // all edges of one length
    default:
        return 1.0;
    }
}

} // namespace

FaceGeometry face_geometry(const Mesh& mesh, const MeshFace& face) {
    const std::size_t count = face.corner_count();
    const auto corner = [&](std::size_t at) -> const Point& {
        return mesh.points[face.corners[at % count]];
    };
    Point middle;
    for (std::size_t at = 0; at < count; ++at)
        middle = middle + (1.0 / static_cast<double>(count)) * corner(at);
    FaceGeometry geometry;
    double sum = 0.0;
    Point weighted;
    for (std::size_t at = 0; at < count; ++at) {
        const Point triangle = 0.5 * cross(corner(at) - middle, corner(at + 1) - middle);
        const double size = length(triangle);
        geometry.area = geometry.area + triangle;
        sum += size;
        weighted = weighted + (size / 3.0) * (corner(at) + corner(at + 1) + middle);
    }
    geometry.centre = sum > 0.0 ? (1.0 / sum) * weighted : middle;
    return geometry;
}

CellGeometry cell_geometry(const Mesh& mesh, const MeshFaces& faces) {
    const std::size_t count = mesh.cells.size();
    CellGeometry cells{std::vector<Point>(count), std::vector<double>(count),
                       std::vector<double>(count)};
    std::vector<Point> middles(count);
    for (std::size_t cell = 0; cell < count; ++cell) {
        const auto corners = mesh.cells.corners(cell);
        for (const std::uint32_t node : corners)
            middles[cell] =
                middles[cell] + (1.0 / static_cast<double>(corners.size())) * mesh.points[node];
    }
    std::vector<Point> open(count);
    const auto add = [&](std::uint32_t cell, const FaceGeometry& face, double sign) {
        const double pyramid = sign * dot(face.area, face.centre - middles[cell]) / 3.0;
        cells.volumes[cell] += pyramid;
        cells.centres[cell] =
            cells.centres[cell] + pyramid * (0.75 * face.centre + 0.25 * middles[cell]);
        open[cell] = open[cell] + sign * face.area;
        cells.openness[cell] += length(face.area);
    };
    for (const auto* list : {&faces.inside, &faces.boundary})
        for (const MeshFace& face : *list) {
            if (face.owner == MeshFace::none)
                continue;
            const FaceGeometry geometry = face_geometry(mesh, face);
            add(face.owner, geometry, 1.0);
            if (face.neighbour != MeshFace::none)
                add(face.neighbour, geometry, -1.0);
        }
    for (std::size_t cell = 0; cell < count; ++cell) {
        cells.centres[cell] = cells.volumes[cell] != 0.0
                                  ? (1.0 / cells.volumes[cell]) * cells.centres[cell]
                                  : middles[cell];
        cells.openness[cell] =
            cells.openness[cell] > 0.0 ? length(open[cell]) / cells.openness[cell] : 1.0;
    }
    return cells;
}

double scaled_jacobian(const Mesh& mesh, std::size_t cell) {
    const CellShape shape = mesh.cells.shape(cell);
    const auto nodes = mesh.cells.corners(cell);
    const auto point = [&](std::int8_t at) -> const Point& {
        return mesh.points[nodes[static_cast<std::size_t>(at)]];
    };
    double least = std::numeric_limits<double>::infinity();
    for (const Trihedron& corner : corners_of(shape)) {
        const Point a = point(corner[1]) - point(corner[0]);
        const Point b = point(corner[2]) - point(corner[0]);
        const Point c = point(corner[3]) - point(corner[0]);
        least = std::min(least, dot(cross(a, b), c) / (length(a) * length(b) * length(c)));
    }
    return std::min(1.0, least / best_of(shape));
}

double aspect_ratio(const Mesh& mesh, std::size_t cell) {
    const auto nodes = mesh.cells.corners(cell);
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (const LocalEdge& edge : edges_of(mesh.cells.shape(cell))) {
        const double size = length(mesh.points[nodes[static_cast<std::size_t>(edge[0])]] -
                                   mesh.points[nodes[static_cast<std::size_t>(edge[1])]]);
        shortest = std::min(shortest, size);
        longest = std::max(longest, size);
    }
    return longest / shortest;
}

} // namespace searle::geometry
