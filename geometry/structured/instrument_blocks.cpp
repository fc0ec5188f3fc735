#include "geometry/structured/instrument_blocks.hpp"

#include "geometry/grading.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/mesh_resolution.hpp"

namespace searle::geometry {
namespace {

using Fractions = std::vector<double>;

/// Cells along a gap that is cut off at both ends: all of one size.
Fractions endless_axial(double height, double axial_cell, const MeshSettings& settings) {
    const int fallback = settings.slice_height ? 1 : 0;
    int count = settings.axial_cells.value_or(fallback);
    if (count == 0)
        count = bounded_count(graded_cell_count(height, {axial_cell, axial_cell, axial_cell, 1.0}),
                              settings.most_cells, "along the cylinder");
    return symmetric_fractions(count, 1.0);
}

/// The rectangle of outline `it`: bottom, outer wall, top, inner wall.
void add_gap(BlockLayout& layout, const Outline& it, const Fractions& across,
             const Fractions& axial) {
    std::array<int, 4> corner{};
    for (std::size_t at = 0; at < 4; ++at)
        corner[at] = layout.corner(it.points[at].r, it.points[at].z);
    const auto edge = [&](std::size_t name, int from, int to, const Fractions& fractions) {
        return layout.edge(from, to, fractions, it.edges[name].patch, it.edges[name].kind);
    };
    const int bottom = edge(0, corner[0], corner[1], across);
    const int right = edge(1, corner[1], corner[2], axial);
    const int top = edge(2, corner[3], corner[2], across);
    const int left = edge(3, corner[0], corner[3], axial);
    layout.block(bottom, right, top, left);
}

BlockLayout separate_gaps(const MeshSubject& subject, double width, const MeshSettings& settings) {
    const MeshDomain domain = domain_of(subject, settings);
    const double height = domain.slice.height;
    const Resolution resolution = resolution_for(domain.gap, height, width, settings);
    const Fractions axial = endless_axial(height, resolution.axial_cell, settings);
    BlockLayout layout;
    for (const Outline& outline : domain.outlines) {
        const double gap = outline.points[1].r - outline.points[0].r;
        add_gap(layout, outline, cells_across(gap, settings).fractions, axial);
    }
    return layout;
}

/// Both gaps and the fluid that joins them under the rotor.
BlockLayout joined_gaps(const DoubleGap& it, const MeshSettings& settings) {
    const auto& [post, inside, outside, cup] = it.radii;
    const double clearance = *floor_clearance_of(it, settings);
    const Resolution size =
        resolution_for(std::min(it.inner_gap(), it.outer_gap()), it.height, cup, settings);
    const auto graded = [&](double length, double start, double end, double largest,
                            const char* what) {
        const Spacing spacing{start, end, largest, size.growth};
        const int count =
            bounded_count(graded_cell_count(length, spacing), settings.most_cells, what);
        return graded_fractions(length, spacing, count);
    };
    const Fractions inner = cells_across(it.inner_gap(), settings).fractions;
    const Fractions outer = cells_across(it.outer_gap(), settings).fractions;
    const Fractions edge_cells =
        graded(outside - inside, size.wall_cell, size.wall_cell, size.bulk_cell, "under the rotor");
    const Fractions below =
        graded(clearance, size.wall_cell, size.wall_cell, size.bulk_cell, "under the rotor");
    const Spacing along{size.wall_cell, size.axial_cell, size.axial_cell, size.growth};
    const int rows = settings.axial_cells.value_or(bounded_count(
        graded_cell_count(it.height, along), settings.most_cells, "along the cylinder"));
    const Fractions axial = graded_fractions(it.height, along, rows);

    BlockLayout layout;
    const std::array<double, 4> radii{post, inside, outside, cup};
    std::array<int, 4> floor{};
    std::array<int, 4> rim{};
    std::array<int, 4> top{};
    for (std::size_t at = 0; at < 4; ++at) {
        floor[at] = layout.corner(radii[at], -clearance);
        rim[at] = layout.corner(radii[at], 0.0);
        top[at] = layout.corner(radii[at], it.height);
    }
    const std::array<const Fractions*, 3> across{&inner, &edge_cells, &outer};
    const auto [inner_wall, outer_wall] = rotor_patches(settings);
    const std::array<const char*, 4> walls{"post", inner_wall, outer_wall, "cup"};
    const std::array<const char*, 4> walls_below{"post", "", "", "cup"};
    std::array<int, 4> below_edge{};
    std::array<int, 4> wall_edge{};
    for (std::size_t at = 0; at < 4; ++at) {
        below_edge[at] = layout.edge(floor[at], rim[at], below, walls_below[at]);
        wall_edge[at] = layout.edge(rim[at], top[at], axial, walls[at]);
    }
    for (std::size_t at = 0; at < 3; ++at) {
        const int bottom = layout.edge(floor[at], floor[at + 1], *across[at], "cup_floor");
        const int middle =
            layout.edge(rim[at], rim[at + 1], *across[at], at == 1 ? "bob_edge" : "");
        layout.block(bottom, below_edge[at + 1], middle, below_edge[at]);
        if (at == 1)
            continue;
        const int surface =
            layout.edge(top[at], top[at + 1], *across[at], "free_surface", PatchKind::free_surface);
        layout.block(middle, wall_edge[at + 1], surface, wall_edge[at]);
    }
    return layout;
}

struct Layout {
    const MeshSettings& settings;

    BlockLayout operator()(const ConcentricCylinders& it) const {
        return separate_gaps(it, it.bob_radius, settings);
    }
    BlockLayout operator()(const DoubleGap& it) const {
        return floor_clearance_of(it, settings) ? joined_gaps(it, settings)
                                                : separate_gaps(it, it.radii[3], settings);
    }
    BlockLayout operator()(const Box& it) const { return separate_gaps(it, it.gap, settings); }
    BlockLayout operator()(const DinBob& it) const {
        return settings.slice_height ? separate_gaps(it, it.bob_radius, settings)
                                     : din_bob_blocks(it, settings);
    }
    BlockLayout operator()(const Profile&) const {
        throw MeshError("a profile has no blocks for mesh.cells = \"hexahedra\"; \"prisms\" and "
                        "\"tetrahedra\" fill any outline");
    }
};

} // namespace

BlockLayout blocks_of(const MeshSubject& subject, const MeshSettings& settings) {
    return std::visit(Layout{settings}, subject);
}

} // namespace searle::geometry
