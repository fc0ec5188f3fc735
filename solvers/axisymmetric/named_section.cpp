#include "solvers/axisymmetric/named_section.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <string>

namespace searle::solvers::axisymmetric {
namespace {

using geometry::Point;

/// Lengths of the arguments are in bob radii, as the lines are.
std::string patch_of(unsigned side, const Point& from, const Point& to,
                     const geometry::DinBob& bob) {
    if (side == symmetry_axis) {
        return "axis";
    }
    if (side == free_surface) {
        return "free_surface";
    }
    if (side == cup_wall) {
        return from.y == -bob.bottom_ratio && to.y == -bob.bottom_ratio ? "cup_floor" : "cup";
    }
    if (std::max(from.y, to.y) <= 0.0) {
        return "bob_cone";
    }
    if (from.x == 1.0 && to.x == 1.0) {
        return "bob";
    }
    return from.y == to.y ? "bob_top" : "shaft";
}

geometry::PatchKind kind_of(unsigned side) {
    return side == symmetry_axis  ? geometry::PatchKind::axis
           : side == free_surface ? geometry::PatchKind::free_surface
                                  : geometry::PatchKind::wall;
}

} // namespace

geometry::BuiltMesh named_section(const geometry::DinBob& bob, const SectionLines& lines) {
    const SectionMesh section = section_of(bob, lines);
    geometry::Mesh mesh;
    mesh.dimension = 2;
    mesh.points.resize(section.vertex_boundary.size());
    struct Side {
        std::array<std::uint32_t, 2> nodes; ///< the fluid on the left
        geometry::PatchKind kind;
    };
    std::map<std::string, std::vector<Side>> sides;
    for (const SectionElement& element : section.elements) {
        const auto node = [&](std::size_t at) {
            return static_cast<std::uint32_t>(element.vertex[at]);
        };
        mesh.points[node(0)] = {element.left, element.bottom_left, 0.0};
        mesh.points[node(1)] = {element.right, element.bottom_right, 0.0};
        mesh.points[node(2)] = {element.left, element.top_left, 0.0};
        mesh.points[node(3)] = {element.right, element.top_right, 0.0};
        mesh.cells.add(geometry::CellShape::quadrangle4,
                       std::array{node(0), node(1), node(3), node(2)});
        // Bottom, top, left and right, each so that the element lies to its left.
        constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{0, 1}, {3, 2}, {2, 0}, {1, 3}}};
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const unsigned side =
                section.edge_boundary[static_cast<std::size_t>(element.edge[edge])];
            if (side == interior_side) {
                continue;
            }
            const auto [from, to] = ends[edge];
            sides[patch_of(side, mesh.points[node(from)], mesh.points[node(to)], bob)].push_back(
                {{node(from), node(to)}, kind_of(side)});
        }
    }
    for (Point& point : mesh.points) {
        point = {point.x * bob.bob_radius, point.y * bob.bob_radius, 0.0};
    }
    for (const auto& [name, members] : sides) {
        mesh.patches.push_back({.name = name,
                                .kind = members.front().kind,
                                .first = mesh.faces.size(),
                                .count = members.size()});
        for (const Side& side : members) {
            mesh.faces.add(geometry::CellShape::line2, side.nodes);
        }
    }
    geometry::BuiltMesh built;
    built.mesh = std::move(mesh);
    built.domain = geometry::domain_of(bob, {});
    built.choices.extent = geometry::MeshExtent::section;
    built.choices.angle = 2.0 * std::numbers::pi;
    return built;
}

} // namespace searle::solvers::axisymmetric
