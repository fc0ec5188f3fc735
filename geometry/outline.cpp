#include "geometry/outline.hpp"

#include <array>
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

OutlineMeasures parabola_measures_of(const std::vector<Outline>& outlines, double cell_angle) {
    OutlineMeasures all = measures_of(outlines);
    // A point at radius 1 runs along P(u) = (1 - (1 - c) u^2, s u), u from -1 to 1, in each cell;
    // c and s are those of half the cell's angle. All swept points have the same P, times their
    // radius, so the volume is that with arcs times the sector of P over the sector of the arc.
    const double c = std::cos(0.5 * cell_angle);
    const double s = std::sin(0.5 * cell_angle);
    all.volume *= 2.0 / 3.0 * s * (4.0 - c) / cell_angle;
    all.patch_areas.clear();
    using Rule = std::array<double, 5>;
    // Gauss's rule of ten points; the integrand is even in u.
    constexpr Rule place{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                         0.8650633666889845, 0.9739065285171717};
    constexpr Rule weight{0.2955242247147529, 0.2692667193099964, 0.2190863625159820,
                          0.1494513491505806, 0.0666713443086881};
    for (const Outline& outline : outlines)
        for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
            const auto [r1, z1] = outline.start(edge);
            const auto [r2, z2] = outline.end(edge);
            double area = 0.0;
            for (std::size_t at = 0; at < place.size(); ++at) {
                const double u = place[at];
                const double speed = std::hypot(2.0 * (1.0 - c) * u, s); // |P'|
                const double turning = s * (1.0 + (1.0 - c) * u * u);    // P x P'
                area += 2.0 * weight[at] * std::hypot((z2 - z1) * speed, (r2 - r1) * turning);
            }
            all.patch_areas[outline.edges[edge].patch] +=
                2.0 * std::numbers::pi / cell_angle * 0.5 * (r1 + r2) * area;
        }
    return all;
}

double curved_tip_volume(double radius, double rise, double cell_angle) {
    // At the share t of the rise the cone's section is t^2 (triangle + segment), the curved
    // triangle's t^2 triangle + t^3 segment; segment = 4/3 s (1 - c) radius^2.
    const double c = std::cos(0.5 * cell_angle);
    const double s = std::sin(0.5 * cell_angle);
    return rise * radius * radius * s * (1.0 - c) / 9.0;
}

} // namespace searle::geometry
