#include "geometry/mesh.hpp"

#include <algorithm>

namespace searle::geometry {
namespace {

struct ShapeFacts {
    std::string_view name;
    std::size_t nodes;
    std::size_t corners;
    int dimension;
    CellShape straight;
    CellShape curved;
};

constexpr std::array<ShapeFacts, 14> facts{{
    {"line", 2, 2, 1, CellShape::line2, CellShape::line3},
    {"triangle", 3, 3, 2, CellShape::triangle3, CellShape::triangle6},
    {"quadrangle", 4, 4, 2, CellShape::quadrangle4, CellShape::quadrangle8},
    {"tetrahedron", 4, 4, 3, CellShape::tetrahedron4, CellShape::tetrahedron10},
    {"pyramid", 5, 5, 3, CellShape::pyramid5, CellShape::pyramid13},
    {"prism", 6, 6, 3, CellShape::prism6, CellShape::prism15},
    {"hexahedron", 8, 8, 3, CellShape::hexahedron8, CellShape::hexahedron20},
    {"curved line", 3, 2, 1, CellShape::line2, CellShape::line3},
    {"curved triangle", 6, 3, 2, CellShape::triangle3, CellShape::triangle6},
    {"curved quadrangle", 8, 4, 2, CellShape::quadrangle4, CellShape::quadrangle8},
    {"curved tetrahedron", 10, 4, 3, CellShape::tetrahedron4, CellShape::tetrahedron10},
    {"curved pyramid", 13, 5, 3, CellShape::pyramid5, CellShape::pyramid13},
    {"curved prism", 15, 6, 3, CellShape::prism6, CellShape::prism15},
    {"curved hexahedron", 20, 8, 3, CellShape::hexahedron8, CellShape::hexahedron20},
}};

const ShapeFacts& facts_of(CellShape shape) { return facts[static_cast<std::size_t>(shape)]; }

// gmsh's order of edges.
constexpr std::array<LocalEdge, 1> line_edges{{{0, 1}}};
constexpr std::array<LocalEdge, 3> triangle_edges{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<LocalEdge, 4> quadrangle_edges{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
constexpr std::array<LocalEdge, 6> tetrahedron_edges{
    {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}};
constexpr std::array<LocalEdge, 8> pyramid_edges{
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}};
constexpr std::array<LocalEdge, 9> prism_edges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}}};
constexpr std::array<LocalEdge, 12> hexahedron_edges{{{0, 1},
                                                      {0, 3},
                                                      {0, 4},
                                                      {1, 2},
                                                      {1, 5},
                                                      {2, 3},
                                                      {2, 6},
                                                      {3, 7},
                                                      {4, 5},
                                                      {4, 7},
                                                      {5, 6},
                                                      {6, 7}}};

constexpr std::array<LocalFace, 4> tetrahedron_faces{
    {{0, 2, 1, -1}, {0, 1, 3, -1}, {0, 3, 2, -1}, {1, 2, 3, -1}}};
constexpr std::array<LocalFace, 5> pyramid_faces{
    {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};
constexpr std::array<LocalFace, 5> prism_faces{
    {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}}};
constexpr std::array<LocalFace, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

} // namespace

std::size_t node_count(CellShape shape) { return facts_of(shape).nodes; }
std::size_t corner_count(CellShape shape) { return facts_of(shape).corners; }
int dimension_of(CellShape shape) { return facts_of(shape).dimension; }
CellShape straight(CellShape shape) { return facts_of(shape).straight; }
CellShape curved(CellShape shape) { return facts_of(shape).curved; }
std::string_view name_of(CellShape shape) { return facts_of(shape).name; }

std::span<const LocalEdge> edges_of(CellShape shape) {
    switch (straight(shape)) {
    case CellShape::triangle3:
        return triangle_edges;
    case CellShape::quadrangle4:
        return quadrangle_edges;
    case CellShape::tetrahedron4:
        return tetrahedron_edges;
    case CellShape::pyramid5:
        return pyramid_edges;
    case CellShape::prism6:
        return prism_edges;
    case CellShape::hexahedron8:
        return hexahedron_edges;
    default:
        return line_edges;
    }
}

std::span<const LocalFace> faces_of(CellShape shape) {
    switch (straight(shape)) {
    case CellShape::tetrahedron4:
        return tetrahedron_faces;
    case CellShape::pyramid5:
        return pyramid_faces;
    case CellShape::prism6:
        return prism_faces;
    case CellShape::hexahedron8:
        return hexahedron_faces;
    default:
        return {};
    }
}

void ElementList::add(CellShape shape, std::span<const std::uint32_t> nodes) {
    shapes_.push_back(shape);
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    starts_.push_back(nodes_.size());
}

void ElementList::reserve(std::size_t elements, std::size_t nodes) {
    shapes_.reserve(elements);
    starts_.reserve(elements + 1);
    nodes_.reserve(nodes);
}

const Patch* Mesh::patch(std::string_view name) const {
    const auto found = std::find_if(patches.begin(), patches.end(),
                                    [name](const Patch& one) { return one.name == name; });
    return found == patches.end() ? nullptr : &*found;
}

bool Mesh::is_second_order() const {
    return cells.size() > 0 && cells.shape(0) != straight(cells.shape(0));
}

} // namespace searle::geometry
