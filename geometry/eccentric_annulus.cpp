#include "geometry/eccentric_annulus.hpp"

#include "geometry/vector3.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace searle::geometry {

EccentricAnnulus::EccentricAnnulus(double inner, double outer, double offset)
    : inner_(inner), outer_(outer) {
    // sinh T in place of cosh T, which is near 1 in a narrow gap.
    const double gap = outer - inner;
    const double sum = outer + inner;
    const double sinh_t =
        std::sqrt((gap - offset) * (gap + offset) * (sum - offset) * (sum + offset)) /
        (2.0 * inner * outer);
    log_ratio_ = std::asinh(sinh_t);
    const double m = offset / (2.0 * outer * sinh_t);
    pole_ = 2.0 * m / (1.0 + std::sqrt(1.0 + 4.0 * m * m));
}

EccentricAnnulus::EccentricAnnulus(const Outline& gap, double offset)
    : EccentricAnnulus(std::ranges::min(gap.points, {}, &SectionPoint::r).r,
                       std::ranges::max(gap.points, {}, &SectionPoint::r).r, offset) {}

Point EccentricAnnulus::placed(const Point& concentric) const {
    const double radius = std::hypot(concentric.x, concentric.y);
    // ln r runs from wall to wall in both gaps.
    const double part = std::log(radius / inner_) / std::log(outer_ / inner_);
    const std::complex<double> from =
        std::exp(log_ratio_ * part) / radius * std::complex(concentric.x, concentric.y);
    const std::complex<double> to = inner_ * (from + pole_) / (1.0 + pole_ * from);
    return {to.real(), to.imag(), concentric.z};
}

double EccentricAnnulus::largest_stretch() const {
    const double far = pole_ * std::exp(log_ratio_);
    return (1.0 + far) / (1.0 - far);
}

OutlineMeasures eccentric_chord_measures(const Outline& outline, double offset, int cells) {
    double height = 0.0;
    for (std::size_t edge = 0; edge < outline.edges.size(); ++edge)
        height = std::max(height, std::abs(outline.end(edge).z - outline.start(edge).z));
    struct Polygon {
        double length{};
        double area{};
    };
    const EccentricAnnulus annulus(outline, offset);
    const auto polygon_at = [&](double radius) {
        Polygon polygon;
        const auto corner = [&](int at) {
            const double angle = 2.0 * std::numbers::pi * at / cells;
            return annulus.placed({radius * std::cos(angle), radius * std::sin(angle), 0.0});
        };
        for (int at = 0; at < cells; ++at) {
            const Point from = corner(at);
            const Point to = corner(at + 1);
            polygon.length += length(to - from);
            polygon.area += 0.5 * cross(from, to).z;
        }
        return polygon;
    };
    const Polygon rotor = polygon_at(annulus.inner());
    const Polygon cup = polygon_at(annulus.outer());
    OutlineMeasures all = measures_of({outline});
    all.volume = (cup.area - rotor.area) * height;
    for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
        const bool is_wall = outline.start(edge).r == outline.end(edge).r;
        all.patch_areas[outline.edges[edge].patch] = !is_wall ? cup.area - rotor.area
                                                     : outline.start(edge).r == annulus.inner()
                                                         ? rotor.length * height
                                                         : cup.length * height;
    }
    return all;
}

} // namespace searle::geometry
