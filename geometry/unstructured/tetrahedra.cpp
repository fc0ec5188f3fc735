#include "geometry/unstructured/tetrahedra.hpp"

#include "geometry/gmsh_module/module.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/unstructured/local_size.hpp"
#include "geometry/unstructured/open_module.hpp"
#include "geometry/vector3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace searle::geometry {
namespace {

using Node = std::uint32_t;

constexpr double widest_thin = 1.0;  ///< rad: wedges up to here have smaller cells near the axis
constexpr double most_flat = 1.5;    ///< size of a cell over the thickness of the wedge there,
constexpr double least_share = 0.15; ///< but no smaller than this share of its size elsewhere

/// Puts points of the walls where the outline has them; gmsh's are near them.
class Placement {
public:
    Placement(const Outline& outline, const SolidExtent& solid, FillingAnswer& answer)
        : outline_{outline}, solid_{solid}, answer_{answer} {}

    void place() {
        std::map<Node, std::set<std::size_t>> edges;
        for (std::size_t edge = 0; edge < answer_.edge_faces.size(); ++edge)
            for (const auto& face : answer_.edge_faces[edge])
                for (const Node node : face)
                    edges[node].insert(edge);
        std::set<Node> front;
        for (const auto& [at_front, at_back] : answer_.pairs)
            front.insert(at_front);
        for (const auto& [node, on] : edges)
            put(node, on_edges(section_of(node), on));
        for (const Node node : front)
            put_on_front(node);
        for (const auto& [at_front, at_back] : answer_.pairs)
            answer_.points[at_back] = behind(answer_.points[at_front]);
    }

private:
    [[nodiscard]] SectionPoint section_of(Node node) const {
        const Point& point = answer_.points[node];
        return solid_.revolved ? SectionPoint{std::hypot(point.x, point.y), point.z}
                               : SectionPoint{point.y, point.z};
    }
    [[nodiscard]] SectionPoint on_edges(const SectionPoint& point,
                                        const std::set<std::size_t>& edges) const {
        if (edges.size() > 1) // a corner of the outline
            return *std::min_element(outline_.points.begin(), outline_.points.end(),
                                     [&](const SectionPoint& one, const SectionPoint& other) {
                                         return std::hypot(one.r - point.r, one.z - point.z) <
                                                std::hypot(other.r - point.r, other.z - point.z);
                                     });
        const SectionPoint& from = outline_.start(*edges.begin());
        const SectionPoint& to = outline_.end(*edges.begin());
        // Nodes at an end of the edge that no other face shares: on the axis.
        const double dr = to.r - from.r;
        const double dz = to.z - from.z;
        const double part =
            ((point.r - from.r) * dr + (point.z - from.z) * dz) / (dr * dr + dz * dz);
        constexpr double rounding = 1e-7;
        if (part < rounding)
            return from;
        if (part > 1.0 - rounding)
            return to;
        return {dr == 0.0 ? from.r : from.r + part * dr, dz == 0.0 ? from.z : from.z + part * dz};
    }
    void put(Node node, const SectionPoint& place) {
        Point& point = answer_.points[node];
        if (!solid_.revolved) {
            point = {point.x, place.r, place.z};
            return;
        }
        const double radius = std::hypot(point.x, point.y);
        if (place.r == 0.0 || radius == 0.0)
            point = {0.0, 0.0, place.z};
        else
            point = {point.x * place.r / radius, point.y * place.r / radius, place.z};
    }
    void put_on_front(Node node) {
        Point& point = answer_.points[node];
        if (!solid_.revolved) {
            point.x = solid_.extent;
            return;
        }
        double radius = std::hypot(point.x, point.y);
        if (radius < 1e-9 * std::abs(outline_radius()))
            radius = 0.0;
        point.x = radius * std::cos(-0.5 * solid_.extent);
        point.y = radius * std::sin(-0.5 * solid_.extent);
    }
    [[nodiscard]] double outline_radius() const {
        double radius = 0.0;
        for (const SectionPoint& point : outline_.points)
            radius = std::max(radius, point.r);
        return radius;
    }
    [[nodiscard]] Point behind(const Point& point) const {
        if (!solid_.revolved)
            return {0.0, point.y, point.z};
        return {point.x, -point.y, point.z}; // the sweep is symmetric about y = 0
    }

    const Outline& outline_;
    const SolidExtent& solid_;
    FillingAnswer& answer_;
};

/// Faces of the boundary with their normals out of the fluid: as the tetrahedron behind each has
/// it.
std::map<std::array<Node, 3>, std::array<Node, 3>>
outward_faces(const std::vector<std::array<Node, 4>>& tetrahedra) {
    std::map<std::array<Node, 3>, std::array<Node, 3>> open;
    for (const auto& cell : tetrahedra)
        for (const LocalFace& face : faces_of(CellShape::tetrahedron4)) {
            const std::array<Node, 3> turn{cell[static_cast<std::size_t>(face[0])],
                                           cell[static_cast<std::size_t>(face[1])],
                                           cell[static_cast<std::size_t>(face[2])]};
            std::array<Node, 3> key = turn;
            std::sort(key.begin(), key.end());
            if (!open.emplace(key, turn).second)
                open.erase(key);
        }
    return open;
}

void turn_positive(FillingAnswer& answer) {
    for (auto& cell : answer.tetrahedra) {
        const Point& a = answer.points[cell[0]];
        const Point volume = cross(answer.points[cell[1]] - a, answer.points[cell[2]] - a);
        if (dot(volume, answer.points[cell[3]] - a) < 0.0)
            std::swap(cell[1], cell[2]);
    }
}

struct Side {
    std::string patch;
    PatchKind kind = PatchKind::wall;
    std::vector<std::array<Node, 3>> faces{};
};

/// Adds what one outline was filled with; gives its faces by patch, the ends last.
std::vector<Side> append(const Outline& outline, const FillingAnswer& answer, Mesh& mesh) {
    const auto offset = static_cast<Node>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), answer.points.begin(), answer.points.end());
    for (const auto& [a, b, c, d] : answer.tetrahedra)
        mesh.cells.add(CellShape::tetrahedron4,
                       std::array{offset + a, offset + b, offset + c, offset + d});
    const auto outward = outward_faces(answer.tetrahedra);
    const auto turned = [&](std::array<Node, 3> face) {
        std::sort(face.begin(), face.end());
        const auto found = outward.find(face);
        if (found == outward.end())
            throw MeshError("gmsh left a face of the boundary without a tetrahedron");
        return std::array{offset + found->second[0], offset + found->second[1],
                          offset + found->second[2]};
    };
    std::vector<Side> sides;
    for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
        Side side{outline.edges[edge].patch, outline.edges[edge].kind};
        for (const auto& face : answer.edge_faces[edge])
            side.faces.push_back(turned(face));
        sides.push_back(std::move(side));
    }
    std::map<Node, Node> behind;
    for (const auto& [front, back] : answer.pairs) {
        behind[front] = back;
        mesh.periodic_points.push_back({offset + front, offset + back});
    }
    Side front{"periodic_front", PatchKind::periodic};
    Side back{"periodic_back", PatchKind::periodic};
    for (const auto& face : answer.front) {
        const std::array<Node, 3> turn = turned(face);
        front.faces.push_back(turn);
        // The same first corner, the other way round, so that pairs match corner by corner.
        std::array<Node, 3> other{};
        for (std::size_t at = 0; at < 3; ++at) {
            const auto found = behind.find(turn[(3 - at) % 3] - offset);
            if (found == behind.end())
                throw MeshError("gmsh's two ends do not match");
            other[at] = found->second + offset;
        }
        back.faces.push_back(other);
    }
    if (!front.faces.empty()) {
        sides.push_back(std::move(front));
        sides.push_back(std::move(back));
    }
    return sides;
}

} // namespace

Mesh filled_with_tetrahedra(const std::vector<Outline>& outlines, const TriangleSizes& sizes,
                            const SolidExtent& solid, std::int64_t most_cells) {
    const auto fill = reinterpret_cast<FillFunction>(gmsh_module_function(fill_symbol));
    double expected = 0.0;
    for (const Outline& outline : outlines)
        expected += LocalSize{outline, sizes}.expected_tetrahedra(solid.revolved, solid.extent);
    if (!(expected <= static_cast<double>(most_cells)))
        throw MeshError(fmt::format("about {:.3g} tetrahedra are more than mesh.most_cells = {} "
                                    "allows",
                                    expected, most_cells));
    Mesh mesh;
    std::vector<Side> sides;
    for (const Outline& outline : outlines) {
        const LocalSize size{outline, sizes};
        FillingAnswer answer;
        const auto size_at = [&](const SectionPoint& point) {
            const double in_section = size.at(point);
            if (!solid.revolved || solid.extent > widest_thin)
                return in_section;
            // Cells much wider in the section than the wedge is thick are flat.
            const double thickness = solid.extent * point.r;
            return std::min(in_section, std::max(most_flat * thickness, least_share * in_section));
        };
        fill({&outline, size_at, solid.revolved, solid.extent, solid.closed}, answer);
        if (!answer.fault.empty())
            throw MeshError(fmt::format("gmsh could not fill the solid: {}", answer.fault));
        Placement{outline, solid, answer}.place();
        turn_positive(answer);
        for (Side& side : append(outline, answer, mesh))
            sides.push_back(std::move(side));
    }
    // By patch, the ends after the walls.
    std::stable_partition(sides.begin(), sides.end(),
                          [](const Side& side) { return side.kind != PatchKind::periodic; });
    for (const Side& first : sides) {
        if (mesh.patch(first.patch) != nullptr)
            continue;
        Patch patch{.name = first.patch, .kind = first.kind, .first = mesh.faces.size()};
        for (const Side& side : sides)
            for (std::size_t face = 0; side.patch == first.patch && face < side.faces.size();
                 ++face)
                mesh.faces.add(CellShape::triangle3, side.faces[face]);
        patch.count = mesh.faces.size() - patch.first;
        if (patch.kind == PatchKind::periodic)
            patch.partner = patch.name == "periodic_front" ? "periodic_back" : "periodic_front";
        if (patch.count > 0)
            mesh.patches.push_back(std::move(patch));
    }
    if (!solid.closed) {
        if (solid.revolved)
            mesh.periodic_map.angle = solid.extent;
        else
            mesh.periodic_map.shift = {-solid.extent, 0.0, 0.0};
    }
    return mesh;
}

} // namespace searle::geometry
