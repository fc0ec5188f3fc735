#include "geometry/outline.hpp"

#include <cmath>
#include <numbers>

namespace searle::geometry {

OutlineMeasures measures_of(const std::vector<Outline>& outlines) {
    OutlineMeasures all;
    for (const Outline& outline : outlines) {
        for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
            const auto [r1, z1] = outline.start(edge);
            const auto [r2, z2] = outline.end(edge);
            const double length = std::hypot(r2 - r1, z2 - z1);
            all.section_area += 0.5 * (r1 + r2) * (z2 - z1);
            // Divergence theorem: the integral of r^2 dz around the section, times pi.
            all.volume += std::numbers::pi * (r1 * r1 + r1 * r2 + r2 * r2) / 3.0 * (z2 - z1);
            all.patch_lengths[outline.edges[edge].patch] += length;
            all.patch_areas[outline.edges[edge].patch] += std::numbers::pi * (r1 + r2) * length;
        }
    }
    return all;
}

OutlineMeasures chord_measures_of(const std::vector<Outline>& outlines, double cell_angle,
                                  double radius_factor) {
    OutlineMeasures all = measures_of(outlines);
    all.section_area *= radius_factor;
    all.volume *= radius_factor * radius_factor * std::sin(cell_angle) / cell_angle;
    all.patch_areas.clear();
    const double turn = 2.0 * std::numbers::pi / cell_angle;
    // A flat piece is a trapezium: two chords, and the distance of their middles.
    const double chord = 2.0 * radius_factor * std::sin(0.5 * cell_angle);
    const double middle = radius_factor * std::cos(0.5 * cell_angle);
    for (const Outline& outline : outlines)
        for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
            const auto [r1, z1] = outline.start(edge);
            const auto [r2, z2] = outline.end(edge);
            all.patch_areas[outline.edges[edge].patch] +=
                turn * chord * 0.5 * (r1 + r2) * std::hypot(middle * (r2 - r1), z2 - z1);
        }
    return all;
}

} // namespace searle::geometry
