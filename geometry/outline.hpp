#pragma once

#include "geometry/mesh.hpp"

#include <map>
#include <string>
#include <vector>

namespace searle::geometry {

/// A point of the meridional half plane; of a box: r across the gap from the bob, z along the
/// width.
struct SectionPoint {
    double r{}; ///< m, >= 0
    double z{}; ///< m
};

/// The edge that leaves an outline's point.
struct OutlineEdge {
    std::string patch;
    PatchKind kind = PatchKind::wall;
    std::string label; ///< for messages: "edge 3 of the rotor"; empty: the patch's name
};

/// The boundary of the fluid in the meridional section: a closed polygon, anticlockwise (fluid on
/// the left). Edge i goes from point i to point i + 1, the last one back to the first.
struct Outline {
    std::vector<SectionPoint> points;
    std::vector<OutlineEdge> edges;

    [[nodiscard]] const SectionPoint& start(std::size_t edge) const { return points[edge]; }
    [[nodiscard]] const SectionPoint& end(std::size_t edge) const {
        return points[(edge + 1) % points.size()];
    }
};

/// What an outline encloses. Closed forms, exact up to rounding.
struct OutlineMeasures {
    double section_area{};                       ///< m^2
    double volume{};                             ///< m^3, of the whole turn (Pappus)
    std::map<std::string, double> patch_areas;   ///< m^2, of the whole turn, by patch
    std::map<std::string, double> patch_lengths; ///< m, in the section, by patch
};

[[nodiscard]] OutlineMeasures measures_of(const std::vector<Outline>& outlines);

/// What a body has whose parts are made with chords in place of arcs: volume and areas of the whole
/// turn, in flat pieces of `cell_angle` (rad) each, radii multiplied by `radius_factor`. The
/// section is that of the multiplied radii.
[[nodiscard]] OutlineMeasures chord_measures_of(const std::vector<Outline>& outlines,
                                                double cell_angle, double radius_factor);

/// What a body has whose arcs are parabolas through both ends and the middle of each `cell_angle`
/// (rad): the cells of second order that a sweep makes. Volume and areas of the whole turn.
/// Faces that end in a point on the axis are left out of it, see curved_tip_volume.
[[nodiscard]] OutlineMeasures parabola_measures_of(const std::vector<Outline>& outlines,
                                                   double cell_angle);

/// Second-order triangles that end on the axis are not the cone over their parabola: what one of
/// them adds to the volume below it, m^3.
/// @param radius  of its far edge, m
/// @param rise    of that edge over the point on the axis, m
[[nodiscard]] double curved_tip_volume(double radius, double rise, double cell_angle);

} // namespace searle::geometry
