#include "geometry/mesh_build.hpp"

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
constexpr double widest_wedge = 10.0 * degree;
/// Of a cell in a sector: its chord is 4.6e-4 shorter in volume than the arc.
constexpr double cell_angle = 3.0 * degree;
constexpr double widest_cell = 90.0 * degree;
constexpr int triangles_across = 8;
constexpr int tetrahedra_across = 3;

MeshExtent extent_for(const MeshSettings& settings) {
    if (settings.extent)
        return *settings.extent;
    if (!settings.wedge_angle || *settings.wedge_angle <= widest_wedge)
        return MeshExtent::wedge;
    return *settings.wedge_angle >= turn * (1 - 1e-12) ? MeshExtent::full : MeshExtent::sector;
}

double angle_for(MeshExtent extent, const MeshSettings& settings) {
    const bool given = settings.wedge_angle.has_value();
    const double angle = settings.wedge_angle.value_or(0.0);
    if (given && !(angle > 0.0 && angle <= turn * (1 + 1e-12)))
        throw MeshError(
            fmt::format("mesh.wedge_angle = {:.6g} deg is not an angle above 0 and up to "
                        "360 deg",
                        angle / degree));
    switch (extent) {
    case MeshExtent::section:
        if (given)
            throw MeshError("mesh.wedge_angle has no meaning for mesh.extent = \"section\"");
        return turn;
    case MeshExtent::wedge:
        return given ? angle : 5.0 * degree;
    case MeshExtent::sector:
        if (given && angle >= turn * (1 - 1e-12))
            throw MeshError("a sector of 360 deg has no sides; mesh.extent = \"full\" is meant");
        return given ? angle : 90.0 * degree;
    case MeshExtent::full:
        if (given && angle < turn * (1 - 1e-12))
            throw MeshError(fmt::format("mesh.wedge_angle = {:.6g} deg contradicts mesh.extent = "
                                        "\"full\"",
                                        angle / degree));
        return turn;
    }
    return turn;
}

double outer_radius(const MeshDomain& domain) {
    double radius = 0.0;
    for (const Outline& outline : domain.outlines)
        for (const SectionPoint& point : outline.points)
            radius = std::max(radius, point.r);
    return radius;
}

int angular_cells_for(const MeshChoices& choices, const MeshDomain& domain,
                      const MeshSettings& settings) {
    const bool is_section = choices.extent == MeshExtent::section;
    if (choices.cells == CellStyle::tetrahedra && !is_section) {
        if (settings.angular_cells)
            throw MeshError("mesh.angular_cells has no meaning for mesh.cells = \"tetrahedra\", "
                            "which are as wide around the axis as in the section");
        return 0;
    }
    if (is_section && settings.angular_cells)
        throw MeshError("mesh.angular_cells has no meaning for mesh.extent = \"section\"");
    int count = is_section ? 0 : 1;
    const char* const what = domain.revolved ? "around the axis" : "along the flow";
    if (settings.angular_cells)
        count = *settings.angular_cells;
    else if (!is_section && choices.extent != MeshExtent::wedge) {
        const double length = domain.revolved ? choices.angle * outer_radius(domain)
                                              : domain.length * choices.angle / turn;
        double wanted = domain.revolved ? std::ceil(choices.angle / cell_angle * (1 - 1e-9)) : 40.0;
        if (settings.cell_size)
            wanted = std::max(wanted, std::ceil(length / *settings.cell_size * (1 - 1e-9)));
        count = bounded_count(wanted, settings.most_cells, what);
    }
    if (domain.revolved && !is_section && choices.angle / count > widest_cell * (1 + 1e-12))
        throw MeshError(
            fmt::format("cells of {:.4g} deg are too wide; mesh.angular_cells must be at "
                        "least {:.0f}",
                        choices.angle / count / degree, std::ceil(choices.angle / widest_cell)));
    if (choices.extent == MeshExtent::full && count < 3)
        throw MeshError("a full turn needs mesh.angular_cells of at least 4");
    return count;
}

MeshChoices choices_in(const MeshDomain& domain, const MeshSubject& subject,
                       const MeshSettings& settings) {
    MeshChoices choices;
    choices.extent = extent_for(settings);
    const bool is_profile = std::holds_alternative<Profile>(subject);
    choices.cells = settings.cells.value_or(is_profile ? CellStyle::prisms : CellStyle::hexahedra);
    choices.order = settings.order.value_or(1);
    choices.angle = angle_for(choices.extent, settings);
    choices.angular_cells = angular_cells_for(choices, domain, settings);
    const bool has_chords = domain.revolved && choices.order == 1 && choices.angular_cells > 0;
    choices.vertices =
        has_chords && choices.extent == MeshExtent::wedge ? VertexRadius::face : VertexRadius::wall;
    if (settings.vertices) {
        if (*settings.vertices == VertexRadius::face && !has_chords)
            throw MeshError("mesh.vertices = \"face\" is for swept straight cells about an axis: "
                            "with mesh.order = 2, in tetrahedra, in a section and in a box there "
                            "are no such chords");
        choices.vertices = *settings.vertices;
    }
    if (choices.vertices == VertexRadius::face)
        choices.radius_factor = 1.0 / std::cos(0.5 * choices.angle / choices.angular_cells);
    return choices;
}

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
    return swept(section, sweep);
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

MeshChoices choices_for(const MeshSubject& subject, const MeshSettings& settings) {
    return choices_in(domain_of(subject, settings), subject, settings);
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
