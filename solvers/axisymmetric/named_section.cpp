#include "solvers/axisymmetric/named_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace searle::solvers::axisymmetric {
namespace {

using geometry::Point;

bool both_at(double place, double one, double other) {
    constexpr double rounding = 1e-12;
    return std::abs(one - place) < rounding && std::abs(other - place) < rounding;
}

/// Lengths of the points are in the shape's unit, as the lines are.
std::string wall_of_bob(unsigned side, const Point& from, const Point& to,
                        const geometry::DinBob& bob) {
    if (side == cup_wall) {
        return both_at(-bob.bottom_ratio, from.y, to.y) ? "cup_floor" : "cup";
    }
    if (std::max(from.y, to.y) <= 0.0) {
        return "bob_cone";
    }
    if (both_at(1.0, from.x, to.x)) {
        return "bob";
    }
    return from.y == to.y ? "bob_top" : "shaft";
}

std::string wall_of_double_gap(unsigned side, const Point& from, const Point& to,
                               const DoubleGapSection& gap, double unit) {
    if (both_at(gap.height / unit, from.y, to.y)) {
        return "free_surface"; // of either gap
    }
    if (side == rotor_wall) {
        return both_at(0.0, from.y, to.y) ? "bob_edge" : "bob";
    }
    if (both_at(-gap.bottom_gap / unit, from.y, to.y)) {
        return "cup_floor";
    }
    return both_at(gap.radii[0] / unit, from.x, to.x) ? "post" : "cup";
}

std::string patch_of(unsigned side, const Point& from, const Point& to, const SectionShape& shape) {
    if (side == symmetry_axis) {
        return "axis";
    }
    if (side == free_surface) {
        return "free_surface";
    }
    return shape.bob() != nullptr
               ? wall_of_bob(side, from, to, *shape.bob())
               : wall_of_double_gap(side, from, to, *shape.double_gap(), shape.unit());
}

geometry::MeshDomain domain_of(const SectionShape& shape) {
    if (const geometry::DinBob* const bob = shape.bob()) {
        return geometry::domain_of(*bob, {});
    }
    const DoubleGapSection& gap = *shape.double_gap();
    return geometry::domain_of(geometry::DoubleGap{gap.radii, gap.height},
                               {.floor_clearance = gap.bottom_gap});
}

geometry::PatchKind kind_of(const std::string& patch) {
    return patch == "axis"           ? geometry::PatchKind::axis
           : patch == "free_surface" ? geometry::PatchKind::free_surface
                                     : geometry::PatchKind::wall;
}

} // namespace

geometry::BuiltMesh named_section(const SectionShape& shape, const SectionLines& lines) {
    const SectionMesh section = section_of(shape, lines);
    geometry::Mesh mesh;
    mesh.dimension = 2;
    mesh.points.resize(section.vertex_boundary.size());
    using Side = std::array<std::uint32_t, 2>; // the fluid on the left
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
            sides[patch_of(side, mesh.points[node(from)], mesh.points[node(to)], shape)].push_back(
                {node(from), node(to)});
        }
    }
    for (Point& point : mesh.points) {
        point = {point.x * shape.unit(), point.y * shape.unit(), 0.0};
    }
    for (const auto& [name, members] : sides) {
        mesh.patches.push_back({.name = name,
                                .kind = kind_of(name),
                                .first = mesh.faces.size(),
                                .count = members.size()});
        for (const Side& side : members) {
            mesh.faces.add(geometry::CellShape::line2, side);
        }
    }
    geometry::BuiltMesh built;
    built.mesh = std::move(mesh);
    built.domain = domain_of(shape);
    built.choices.extent = geometry::MeshExtent::section;
    built.choices.angle = 2.0 * std::numbers::pi;
    return built;
}

} // namespace searle::solvers::axisymmetric
