#include "geometry/mesh_choices.hpp"

#include "geometry/eccentric_annulus.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/mesh_resolution.hpp"

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
/// On the wide side of an eccentric gap, where angles are largest.
constexpr double widest_eccentric_cell = 6.0 * degree;

double stretch_of(const MeshDomain& domain) {
    return EccentricAnnulus(domain.outlines.front(), domain.offset).largest_stretch();
}

/// Around an eccentric bob no two directions are alike, and no circle is where the sweep puts it.
void check_eccentric(const MeshSettings& settings) {
    const auto refuse = [](const char* what, const char* allowed) {
        throw MeshError(fmt::format("{} does not go with geometry.offset: {}", what, allowed));
    };
    if (settings.extent && *settings.extent != MeshExtent::full)
        refuse("a part of the turn (mesh.extent, a section)",
               "around an eccentric bob the flow is another in every direction; mesh.extent = "
               "\"full\" is the one that there is");
    if (settings.wedge_angle && *settings.wedge_angle < turn * (1 - 1e-12))
        refuse("mesh.wedge_angle below 360 deg",
               "around an eccentric bob the flow is another in every direction");
    if (settings.cells == CellStyle::tetrahedra)
        refuse("mesh.cells = \"tetrahedra\"", "\"hexahedra\" and \"prisms\" do");
    if (settings.order.value_or(1) != 1)
        refuse("mesh.order = 2", "its cells have straight edges, order = 1");
    if (settings.vertices == VertexRadius::face)
        refuse("mesh.vertices = \"face\"", "cells differ in angle, so vertices lie on the walls");
}

MeshExtent extent_for(const MeshDomain& domain, const MeshSettings& settings) {
    if (domain.offset > 0.0) {
        check_eccentric(settings);
        return MeshExtent::full;
    }
    return extent_of(settings);
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
        if (domain.offset > 0.0)
            wanted = std::max(wanted, std::ceil(turn / widest_eccentric_cell * stretch_of(domain)));
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

} // namespace

MeshExtent extent_of(const MeshSettings& settings) {
    if (settings.extent)
        return *settings.extent;
    if (!settings.wedge_angle || *settings.wedge_angle <= widest_wedge)
        return MeshExtent::wedge;
    return *settings.wedge_angle >= turn * (1 - 1e-12) ? MeshExtent::full : MeshExtent::sector;
}

MeshChoices choices_in(const MeshDomain& domain, const MeshSubject& subject,
                       const MeshSettings& settings) {
    MeshChoices choices;
    choices.extent = extent_for(domain, settings);
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

double outer_radius(const MeshDomain& domain) {
    double radius = 0.0;
    for (const Outline& outline : domain.outlines)
        for (const SectionPoint& point : outline.points)
            radius = std::max(radius, point.r);
    return radius;
}

} // namespace searle::geometry
