#include "geometry/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace searle::geometry {
namespace {

using Node = std::uint32_t;

std::uint64_t key_of(Node one, Node other) {
    return (static_cast<std::uint64_t>(std::min(one, other)) << 32) | std::max(one, other);
}

/// The middle of an edge; about the axis the mean of radius, angle and height.
Point middle(const Point& one, const Point& other, bool revolved) {
    const Point mean{0.5 * (one.x + other.x), 0.5 * (one.y + other.y), 0.5 * (one.z + other.z)};
    if (!revolved)
        return mean;
    const double first = std::hypot(one.x, one.y);
    const double second = std::hypot(other.x, other.y);
    if (first == 0.0 || second == 0.0)
        return mean;
    const double x = one.x / first + other.x / second;
    const double y = one.y / first + other.y / second;
    const double radius = 0.5 * (first + second) / std::hypot(x, y);
    return {radius * x, radius * y, mean.z};
}

void gather_edges(const ElementList& elements, std::vector<std::uint64_t>& edges) {
    for (std::size_t at = 0; at < elements.size(); ++at) {
        const auto nodes = elements.corners(at);
        for (const LocalEdge& edge : edges_of(elements.shape(at)))
            edges.push_back(key_of(nodes[static_cast<std::size_t>(edge[0])],
                                   nodes[static_cast<std::size_t>(edge[1])]));
    }
}

ElementList with_middles(const ElementList& elements, const std::vector<std::uint64_t>& edges,
                         Node first_middle) {
    ElementList result;
    std::vector<Node> nodes;
    for (std::size_t at = 0; at < elements.size(); ++at) {
        const auto corners = elements.corners(at);
        nodes.assign(corners.begin(), corners.end());
        for (const LocalEdge& edge : edges_of(elements.shape(at))) {
            const std::uint64_t key = key_of(corners[static_cast<std::size_t>(edge[0])],
                                             corners[static_cast<std::size_t>(edge[1])]);
            const auto found = std::lower_bound(edges.begin(), edges.end(), key);
            nodes.push_back(first_middle + static_cast<Node>(found - edges.begin()));
        }
        result.add(curved(elements.shape(at)), nodes);
    }
    return result;
}

/// Sorted.
std::vector<std::uint64_t> wall_edges(const Mesh& mesh) {
    ElementList walls;
    for (const Patch& patch : mesh.patches)
        if (patch.kind == PatchKind::wall || patch.kind == PatchKind::free_surface ||
            patch.kind == PatchKind::end_face)
            for (std::size_t face = patch.first; face < patch.first + patch.count; ++face)
                walls.add(mesh.faces.shape(face), mesh.faces.nodes(face));
    std::vector<std::uint64_t> edges;
    gather_edges(walls, edges);
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

Mesh second_order(const Mesh& mesh, CurvedEdges curved_edges) {
    std::vector<std::uint64_t> edges;
    gather_edges(mesh.cells, edges);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges.shrink_to_fit();

    Mesh result;
    result.dimension = mesh.dimension;
    result.points = mesh.points;
    result.patches = mesh.patches;
    result.periodic_map = mesh.periodic_map;
    const auto first_middle = static_cast<Node>(mesh.points.size());
    const std::vector<std::uint64_t> at_walls =
        curved_edges == CurvedEdges::walls ? wall_edges(mesh) : std::vector<std::uint64_t>{};
    for (const std::uint64_t key : edges) {
        const bool is_curved = curved_edges == CurvedEdges::all ||
                               std::binary_search(at_walls.begin(), at_walls.end(), key);
        result.points.push_back(middle(mesh.points[static_cast<Node>(key >> 32)],
                                       mesh.points[static_cast<Node>(key)], is_curved));
    }
    result.cells = with_middles(mesh.cells, edges, first_middle);
    result.faces = with_middles(mesh.faces, edges, first_middle);

    result.periodic_points = mesh.periodic_points;
    for (const Patch& patch : mesh.patches) {
        if (patch.partner.empty() || !patch.name.ends_with("front"))
            continue;
        const Patch& back = *mesh.patch(patch.partner);
        for (std::size_t face = 0; face < patch.count; ++face) {
            const auto front_nodes = result.faces.nodes(patch.first + face);
            const auto back_nodes = result.faces.nodes(back.first + face);
            const std::size_t corners = corner_count(result.faces.shape(patch.first + face));
            // The back turns the other way round: its edges follow in the opposite order.
            for (std::size_t at = 0; at < corners; ++at)
                result.periodic_points.push_back(
                    {front_nodes[corners + at], back_nodes[corners + (corners - 1 - at)]});
        }
    }
    std::sort(result.periodic_points.begin(), result.periodic_points.end());
    result.periodic_points.erase(
        std::unique(result.periodic_points.begin(), result.periodic_points.end()),
        result.periodic_points.end());
    return result;
}

} // namespace searle::geometry
