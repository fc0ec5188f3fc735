#include "geometry/mesh_faces.hpp"

#include <algorithm>

namespace searle::geometry {
namespace {

using Node = std::uint32_t;
using Corners = std::array<Node, 4>;

/// A face seen from a cell, or (local < 0) from the boundary.
struct HalfFace {
    std::uint32_t element;
    std::int32_t local;
};

Corners corners_of(const Mesh& mesh, const HalfFace& half) {
    Corners corners;
    corners.fill(MeshFace::none);
    if (half.local < 0) {
        const auto nodes = mesh.faces.corners(half.element);
        std::copy(nodes.begin(), nodes.end(), corners.begin());
        return corners;
    }
    const auto nodes = mesh.cells.corners(half.element);
    const LocalFace& face =
        faces_of(mesh.cells.shape(half.element))[static_cast<std::size_t>(half.local)];
    for (std::size_t at = 0; at < 4; ++at)
        if (face[at] >= 0)
            corners[at] = nodes[static_cast<std::size_t>(face[at])];
    return corners;
}

bool same_nodes(Corners one, Corners other) {
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    return one == other;
}

/// True when two faces with the same nodes go round them in the same direction.
bool same_turn(const Corners& one, const Corners& other) {
    const std::size_t count = one[3] == MeshFace::none ? 3 : 4;
    for (std::size_t at = 0; at < count; ++at)
        if (other[at] == one[0])
            return other[(at + 1) % count] == one[1];
    return false;
}

template <class Use>
void for_each_half_face(const Mesh& mesh, Use use) {
    for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell) {
        const auto count = static_cast<std::int32_t>(faces_of(mesh.cells.shape(cell)).size());
        for (std::int32_t local = 0; local < count; ++local)
            use(HalfFace{cell, local});
    }
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
        use(HalfFace{face, -1});
}

Node lowest_of(const Corners& corners) { return *std::min_element(corners.begin(), corners.end()); }

} // namespace

MeshFaces faces_of_cells(const Mesh& mesh) {
    // Half faces sorted into buckets by their lowest node: a few dozen each at most.
    std::vector<std::uint32_t> starts(mesh.points.size() + 1, 0);
    for_each_half_face(
        mesh, [&](const HalfFace& half) { ++starts[lowest_of(corners_of(mesh, half)) + 1]; });
    for (std::size_t node = 0; node < mesh.points.size(); ++node)
        starts[node + 1] += starts[node];
    std::vector<HalfFace> halves(starts.back());
    {
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for_each_half_face(mesh, [&](const HalfFace& half) {
            halves[next[lowest_of(corners_of(mesh, half))]++] = half;
        });
    }

    MeshFaces faces;
    faces.boundary.resize(mesh.faces.size());
    faces.inside.reserve((halves.size() - 2 * mesh.faces.size()) / 2 + mesh.faces.size());
    std::vector<Corners> bucket;
    std::vector<bool> is_matched;
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
        const HalfFace* const first = halves.data() + starts[node];
        const std::size_t count = starts[node + 1] - starts[node];
        bucket.resize(count);
        is_matched.assign(count, false);
        for (std::size_t at = 0; at < count; ++at)
            bucket[at] = corners_of(mesh, first[at]);
        for (std::size_t one = 0; one < count; ++one) {
            if (is_matched[one])
                continue;
            std::size_t other = one + 1;
            while (other < count && (is_matched[other] || !same_nodes(bucket[one], bucket[other])))
                ++other;
            if (other == count) {
                ++faces.unmatched;
                continue;
            }
            is_matched[other] = true;
            const bool at_boundary = first[other].local < 0;
            if (same_turn(bucket[one], bucket[other]) != at_boundary)
                ++faces.misoriented;
            // Cells come in ascending order, the boundary after them.
            if (first[one].local < 0)
                ++faces.unmatched;
            else if (at_boundary)
                faces.boundary[first[other].element] = {bucket[other], first[one].element,
                                                        MeshFace::none};
            else
                faces.inside.push_back({bucket[one], first[one].element, first[other].element});
        }
    }
    std::sort(
        faces.inside.begin(), faces.inside.end(), [](const MeshFace& one, const MeshFace& two) {
            return one.owner != two.owner ? one.owner < two.owner : one.neighbour < two.neighbour;
        });
    return faces;
}

} // namespace searle::geometry
