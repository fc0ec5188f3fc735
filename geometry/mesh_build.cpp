#include "geometry/mesh_build.hpp"

#include "geometry/eccentric_annulus.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/mesh_resolution.hpp"
#include "geometry/structured/instrument_blocks.hpp"
#include "geometry/sweep.hpp"
#include "geometry/unstructured/tetrahedra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double turn = 2.0 * std::numbers::pi;
constexpr int triangles_across = 8;
constexpr int tetrahedra_across = 3;

Mesh structured_section(const MeshSubject& subject, const MeshChoices& choices,
                        const MeshSettings& settings) {
    const BlockLayout layout = blocks_of(subject, settings);
    const double total =
        static_cast<double>(layout.cell_count()) * std::max(1, choices.angular_cells);
    bounded_count(total, settings.most_cells, "in all");
    return section_of(layout);
}

TriangleSizes triangle_sizes(const MeshDomain& domain, const MeshChoices& choices,
                             const MeshSettings& settings) {
    if (settings.first_cell)
        throw MeshError("mesh.first_cell is for mesh.cells = \"hexahedra\"; triangles take "
                        "mesh.cells_across_gap or mesh.cell_size");
    if (settings.cell_size)
        (void)cells_across(domain.gap, settings);
    const bool is_tetrahedral =
        choices.cells == CellStyle::tetrahedra && choices.extent != MeshExtent::section;
    TriangleSizes sizes;
    sizes.across =
        settings.cells_across_gap.value_or(is_tetrahedral ? tetrahedra_across : triangles_across);
    sizes.fixed = settings.cell_size.value_or(0.0);
    sizes.growth = settings.growth.value_or(1.2);
    sizes.largest =
        std::max(1.5 * domain.gap / sizes.across, 0.8 * outer_radius(domain) / sizes.across);
    return sizes;
}

Mesh tetrahedral_solid(const MeshDomain& domain, const MeshChoices& choices,
                       const MeshSettings& settings) {
    const SolidExtent solid{.revolved = domain.revolved,
                            .extent = domain.revolved ? choices.angle
                                                      : domain.length * choices.angle / turn,
                            .closed = domain.revolved && choices.extent == MeshExtent::full};
    return filled_with_tetrahedra(domain.outlines, triangle_sizes(domain, choices, settings), solid,
                                  settings.most_cells);
}

Mesh triangle_section(const MeshDomain& domain, const MeshChoices& choices,
                      const MeshSettings& settings) {
    return triangulated(domain.outlines, triangle_sizes(domain, choices, settings),
                        settings.most_cells / std::max(1, choices.angular_cells));
}

Mesh solid_of(Mesh section, const MeshDomain& domain, const MeshChoices& choices) {
    if (domain.revolved)
        section = with_triangles_at_axis_corners(section);
    Sweep sweep{.revolved = domain.revolved, .cells = choices.angular_cells};
    sweep.extent = domain.revolved ? choices.angle : domain.length * choices.angle / turn;
    sweep.radius_factor = choices.radius_factor;
    const bool is_wedge =
        choices.extent == MeshExtent::wedge && choices.angular_cells == 1 && domain.revolved;
    sweep.ends = is_wedge                                                ? Sweep::Ends::wedge
                 : choices.extent == MeshExtent::full && domain.revolved ? Sweep::Ends::closed
                                                                         : Sweep::Ends::periodic;
    Mesh solid = swept(section, sweep);
    if (domain.offset > 0.0) {
        const EccentricAnnulus annulus(domain.outlines.front(), domain.offset);
        for (Point& point : solid.points)
            point = annulus.placed(point);
    }
    return solid;
}

std::vector<std::string> notes_on(const BuiltMesh& built) {
    const MeshChoices& choices = built.choices;
    std::vector<std::string> notes;
    const bool is_solid = choices.extent != MeshExtent::section;
    if (is_solid && choices.cells == CellStyle::tetrahedra)
        notes.push_back("tetrahedra have their vertices on the true walls; its two ends are a "
                        "periodic pair");
    else if (built.domain.revolved && is_solid && choices.order == 1) {
        const double part = built.expected().volume / built.exact().volume;
        const double half = 0.5 * choices.angle / choices.angular_cells;
        if (choices.vertices == VertexRadius::face)
            notes.push_back(
                fmt::format("vertices lie at radius / cos({:.4g} deg), so that the centres of the "
                            "walls' faces lie "
                            "on the true radii; the volume is {:.6f} times that with arcs",
                            half / degree, part));
        else
            notes.push_back(
                fmt::format("vertices lie on the true radii; with chords in place of arcs "
                            "the volume is {:.6f} times that with arcs",
                            part));
    }
    if (choices.extent == MeshExtent::wedge && choices.angular_cells > 1)
        notes.push_back("the wedge is several cells thick, so its sides are a periodic pair");
    return notes;
}

} // namespace

double BuiltMesh::part() const { return choices.angle / turn; }

OutlineMeasures BuiltMesh::exact() const {
    OutlineMeasures all = measures_of(domain.outlines);
    const double length = domain.length * part();
    all.volume = domain.revolved ? all.volume * part() : all.section_area * length;
    for (auto& [patch, area] : all.patch_areas)
        area = domain.revolved ? area * part() : all.patch_lengths[patch] * length;
    return all;
}

OutlineMeasures BuiltMesh::expected() const {
    if (!domain.revolved || choices.angular_cells == 0)
        return exact();
    if (domain.offset > 0.0)
        return eccentric_chord_measures(domain.outlines.front(), domain.offset,
                                        choices.angular_cells);
    if (choices.order == 2)
        return expected_of_curved_cells();
    OutlineMeasures all = chord_measures_of(domain.outlines, choices.angle / choices.angular_cells,
                                            choices.radius_factor);
    all.volume *= part();
    for (auto& [patch, area] : all.patch_areas)
        area *= part();
    return all;
}

OutlineMeasures BuiltMesh::expected_of_curved_cells() const {
    const double cell = choices.angle / choices.angular_cells;
    OutlineMeasures all = parabola_measures_of(domain.outlines, cell);
    all.volume *= part();
    for (auto& [patch, area] : all.patch_areas)
        area *= part();
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto corners = mesh.faces.corners(face);
        const auto on_axis = [&](std::size_t at) {
            const Point& point = mesh.points[corners[at % 3]];
            return point.x == 0.0 && point.y == 0.0;
        };
        for (std::size_t at = 0; corners.size() == 3 && at < 3; ++at) {
            if (!on_axis(at) || on_axis(at + 1) || on_axis(at + 2))
                continue;
            const Point& tip = mesh.points[corners[at]];
            const Point& one = mesh.points[corners[(at + 1) % 3]];
            const Point& two = mesh.points[corners[(at + 2) % 3]];
            const double turn = one.x * two.y - one.y * two.x; // of the normal out of the fluid
            const double product = std::hypot(one.x, one.y) * std::hypot(two.x, two.y);
            if (std::abs(turn) > 1e-9 * product) // else a face of a sweep's end, which is flat
                all.volume += (turn > 0.0 ? 1.0 : -1.0) *
                              curved_tip_volume(std::hypot(one.x, one.y), one.z - tip.z, cell);
        }
    }
    return all;
}

BuiltMesh build_mesh(const MeshSubject& subject, const MeshSettings& settings) {
    BuiltMesh built;
    built.domain = domain_of(subject, settings);
    built.choices = choices_in(built.domain, subject, settings);
    const MeshChoices& choices = built.choices;
    const bool is_section = choices.extent == MeshExtent::section;
    const bool is_filled = choices.cells == CellStyle::tetrahedra && !is_section;
    const bool is_revolved = built.domain.revolved && !is_section;
    Mesh mesh = is_filled ? tetrahedral_solid(built.domain, choices, settings)
                : choices.cells == CellStyle::hexahedra
                    ? structured_section(subject, choices, settings)
                    : triangle_section(built.domain, choices, settings);
    if (!is_section && !is_filled)
        mesh = solid_of(std::move(mesh), built.domain, choices);
    if (choices.order == 2)
        mesh = second_order(mesh, !is_revolved ? CurvedEdges::none
                                  : is_filled  ? CurvedEdges::walls
                                               : CurvedEdges::all);
    built.mesh = std::move(mesh);
    built.domain.slice.angle = choices.angle;
    built.notes = notes_on(built);
    return built;
}

} // namespace searle::geometry
