#include "geometry/mesh_subject.hpp"

#include "geometry/mesh_error.hpp"
#include "geometry/outline_check.hpp"
#include "geometry/profile_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

namespace searle::geometry {
namespace {

constexpr OutlineEdge wall(const char* name) { return {name, PatchKind::wall, ""}; }

/// Only structured cells are known to be one high.
PatchKind end_kind(const MeshSettings& settings) {
    if (settings.cells.value_or(CellStyle::hexahedra) != CellStyle::hexahedra)
        return PatchKind::end_face;
    return settings.axial_cells.value_or(0) == 1 ||
                   (settings.slice_height && settings.axial_cells.value_or(1) == 1)
               ? PatchKind::flat
               : PatchKind::end_face;
}

/// The rectangle between a rotor's and a cup's cylinder, cut off at both ends.
Outline gap_outline(double inner, double outer, double height, const char* inner_patch,
                    const char* outer_patch, PatchKind ends) {
    return {{{inner, 0.0}, {outer, 0.0}, {outer, height}, {inner, height}},
            {{"slice_bottom", ends, ""},
             wall(outer_patch),
             {"slice_top", ends, ""},
             wall(inner_patch)}};
}

double checked_height(double instrument_height, const MeshSettings& settings) {
    const double height = settings.slice_height.value_or(instrument_height);
    if (height > instrument_height * (1.0 + 1e-12))
        throw MeshError(fmt::format("mesh.slice_height = {:.6g} mm is more than the {:.6g} mm of "
                                    "the instrument's cylinder",
                                    height * 1e3, instrument_height * 1e3));
    return height;
}

struct Draw {
    const MeshSettings& settings;

    MeshDomain operator()(const ConcentricCylinders& it) const {
        const double height = checked_height(it.height, settings);
        return {.outlines = {gap_outline(it.bob_radius, it.cup_radius, height, "bob", "cup",
                                         end_kind(settings))},
                .gap = it.gap(),
                .offset = it.offset,
                .slice = {.height = height, .instrument_height = it.height}};
    }
    MeshDomain operator()(const Box& it) const {
        const double height = checked_height(it.width, settings);
        return {.outlines = {gap_outline(0.0, it.gap, height, "bob", "cup", end_kind(settings))},
                .revolved = false,
                .length = it.length,
                .gap = it.gap,
                .slice = {.height = height, .instrument_height = it.width}};
    }
    MeshDomain operator()(const DoubleGap& it) const {
        const auto& [post, inside, outside, cup] = it.radii;
        const double height = checked_height(it.height, settings);
        const auto [inner, outer] = rotor_patches(settings);
        MeshDomain domain{.gap = std::min(it.inner_gap(), it.outer_gap()),
                          .slice = {.height = height, .instrument_height = it.height}};
        const std::optional<double> clearance = floor_clearance_of(it, settings);
        if (!clearance) {
            const PatchKind ends = end_kind(settings);
            domain.outlines = {gap_outline(post, inside, height, "post", inner, ends),
                               gap_outline(outside, cup, height, outer, "cup", ends)};
            return domain;
        }
        if (settings.slice_height)
            throw MeshError(
                "mesh.slice_height and mesh.floor_clearance exclude each other: a slice "
                "does not reach the floor");
        const double floor = -*clearance;
        const OutlineEdge surface{"free_surface", PatchKind::free_surface, ""};
        domain.outlines = {{{{post, floor},
                             {cup, floor},
                             {cup, height},
                             {outside, height},
                             {outside, 0.0},
                             {inside, 0.0},
                             {inside, height},
                             {post, height}},
                            {wall("cup_floor"), wall("cup"), surface, wall(outer), wall("bob_edge"),
                             wall(inner), surface, wall("post")}}};
        return domain;
    }
    MeshDomain operator()(const DinBob& it) const {
        if (settings.slice_height) {
            const double height = checked_height(it.height(), settings);
            return {.outlines = {gap_outline(it.bob_radius, it.cup_radius, height, "bob", "cup",
                                             end_kind(settings))},
                    .gap = it.gap(),
                    .slice = {.height = height, .instrument_height = it.height()}};
        }
        if (it.top_ratio > 0.0 && !(it.shaft_ratio > 0.0 && it.shaft_ratio < 1.0))
            throw MeshError(
                fmt::format("the shaft, geometry.shaft_ratio = {:.6g}, is not thinner than "
                            "the bob",
                            it.shaft_ratio));
        if (!(it.cone_angle > 0.0 && it.cone_angle <= std::numbers::pi))
            throw MeshError(
                fmt::format("geometry.cone_angle = {:.6g} deg is not between 0 and 180 deg",
                            it.cone_angle * 180.0 / std::numbers::pi));
        if (it.top_ratio < 0.0)
            throw MeshError(
                fmt::format("the liquid's level, geometry.top_ratio = {:.6g}, is below the "
                            "bob's top",
                            it.top_ratio));
        if (!(it.tip_clearance() > 0.0))
            throw MeshError(fmt::format("the cone's tip reaches the floor (cup_floor): "
                                        "geometry.bottom_ratio = {:.6g} is not above {:.6g}",
                                        it.bottom_ratio, it.cone_height() / it.bob_radius));
        const double R = it.bob_radius;
        const double top = it.height() + it.top_ratio * R;
        const double shaft = it.shaft_ratio * R;
        Outline outline;
        const auto edge = [&outline](SectionPoint from, const char* name, PatchKind kind) {
            outline.points.push_back(from);
            outline.edges.push_back({name, kind, ""});
        };
        edge({0.0, -it.bottom_ratio * R}, "cup_floor", PatchKind::wall);
        edge({it.cup_radius, -it.bottom_ratio * R}, "cup", PatchKind::wall);
        edge({it.cup_radius, top}, "free_surface", PatchKind::free_surface);
        if (it.top_ratio > 0.0) {
            edge({shaft, top}, "shaft", PatchKind::wall);
            edge({shaft, it.height()}, "bob_top", PatchKind::wall);
        }
        edge({R, it.height()}, "bob", PatchKind::wall);
        edge({R, 0.0}, "bob_cone", PatchKind::wall);
        edge({0.0, -it.cone_height()}, "axis", PatchKind::axis);
        return {.outlines = {std::move(outline)},
                .gap = it.gap(),
                .slice = {.height = it.height(), .instrument_height = it.height()}};
    }
    MeshDomain operator()(const Profile& it) const {
        if (settings.slice_height)
            throw MeshError("mesh.slice_height is for instruments with a cylinder; a profile is "
                            "meshed as it is drawn");
        Outline outline = outline_of(it);
        MeshDomain domain{.slice = {.height = 1.0, .instrument_height = 1.0}};
        domain.gap = check_outline(outline).clearance;
        domain.outlines = {std::move(outline)};
        return domain;
    }
};

} // namespace

std::array<const char*, 2> rotor_patches(const MeshSettings& settings) {
    if (settings.rotor_walls.value_or(RotorWalls::together) == RotorWalls::separate)
        return {"bob_inner", "bob_outer"};
    return {"bob", "bob"};
}

MeshSubject subject_of(const Instrument& instrument) {
    if (const auto* gap = std::get_if<ConcentricCylinders>(&instrument);
        gap != nullptr && gap->ends)
        return with_flat_bottom(*gap);
    return std::visit([](const auto& it) -> MeshSubject { return it; }, instrument);
}

std::optional<double> floor_clearance_of(const DoubleGap& gap, const MeshSettings& settings) {
    if (!gap.ends || settings.slice_height)
        return settings.floor_clearance;
    if (settings.floor_clearance && *settings.floor_clearance != gap.bottom_gap)
        throw MeshError(fmt::format("mesh.floor_clearance = {:.6g} mm, but the floor is "
                                    "geometry.bottom_gap = {:.6g} mm below the rotor",
                                    *settings.floor_clearance * 1e3, gap.bottom_gap * 1e3));
    return gap.bottom_gap;
}

MeshDomain domain_of(const MeshSubject& subject, const MeshSettings& settings) {
    MeshDomain domain = std::visit(Draw{settings}, subject);
    if (settings.rotor_walls && !std::holds_alternative<DoubleGap>(subject))
        throw MeshError("mesh.rotor_walls is for the double gap: other rotors have one wall");
    if (settings.floor_clearance && !std::holds_alternative<DoubleGap>(subject))
        throw MeshError("mesh.floor_clearance is for the double gap; other instruments say where "
                        "their floor is");
    for (const Outline& outline : domain.outlines)
        (void)check_outline(outline);
    return domain;
}

} // namespace searle::geometry
