#include "geometry/unstructured/local_size.hpp"

#include "geometry/outline_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::geometry {
namespace {

/// Cells at a re-entrant corner are this much smaller than the local width alone makes them.
constexpr double corner_refinement = 3.0;

double distance_to(const SectionPoint& point, const SectionPoint& from, const SectionPoint& to) {
    const double dr = to.r - from.r;
    const double dz = to.z - from.z;
    const double along = ((point.r - from.r) * dr + (point.z - from.z) * dz) / (dr * dr + dz * dz);
    const double part = std::clamp(along, 0.0, 1.0);
    return std::hypot(point.r - from.r - part * dr, point.z - from.z - part * dz);
}

} // namespace

LocalSize::LocalSize(const Outline& outline, const TriangleSizes& sizes)
    : outline_{outline}, sizes_{sizes} {
    const std::size_t count = outline.edges.size();
    for (std::size_t edge = 0; edge < count; ++edge) {
        if (outline.edges[edge].kind != PatchKind::wall)
            continue;
        (is_rotor_patch(outline.edges[edge].patch) ? rotor_edges_ : fixed_edges_).push_back(edge);
    }
    for (std::size_t at = 0; at < count; ++at) {
        const std::size_t before = (at + count - 1) % count;
        const SectionPoint& last = outline.start(before);
        const SectionPoint& here = outline.start(at);
        const SectionPoint& next = outline.end(at);
        const double turn =
            (here.r - last.r) * (next.z - here.z) - (here.z - last.z) * (next.r - here.r);
        const bool are_walls = outline.edges[at].kind == PatchKind::wall &&
                               outline.edges[before].kind == PatchKind::wall;
        if (turn < 0.0 && are_walls && sizes.fixed <= 0.0) {
            corners_.push_back(here);
            corner_sizes_.push_back(
                std::min(sizes.largest, width_at(here) / sizes.across / corner_refinement));
        }
    }
}

double LocalSize::width_at(const SectionPoint& point) const {
    const auto nearest = [&](const std::vector<std::size_t>& edges) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t edge : edges)
            least = std::min(least, distance_to(point, outline_.start(edge), outline_.end(edge)));
        return least;
    };
    return nearest(rotor_edges_) + nearest(fixed_edges_);
}

double LocalSize::at(const SectionPoint& point) const {
    if (sizes_.fixed > 0.0)
        return sizes_.fixed;
    double size = std::min(sizes_.largest, width_at(point) / sizes_.across);
    for (std::size_t corner = 0; corner < corners_.size(); ++corner)
        size = std::min(size, corner_sizes_[corner] +
                                  (sizes_.growth - 1.0) * std::hypot(point.r - corners_[corner].r,
                                                                     point.z - corners_[corner].z));
    return size;
}

template <class Cells>
double LocalSize::sum_over_section(Cells cells) const {
    // Each wall answers for half of the local width beside it.
    constexpr int samples = 50;
    double sum = 0.0;
    for (const auto* edges : {&rotor_edges_, &fixed_edges_})
        for (const std::size_t edge : *edges) {
            const SectionPoint& from = outline_.start(edge);
            const SectionPoint& to = outline_.end(edge);
            const double length = std::hypot(to.r - from.r, to.z - from.z);
            for (int sample = 0; sample < samples; ++sample) {
                const double part = (sample + 0.5) / samples;
                const SectionPoint point{from.r + part * (to.r - from.r),
                                         from.z + part * (to.z - from.z)};
                sum += cells(point, at(point), 0.5 * width_at(point) * length / samples);
            }
        }
    return sum;
}

double LocalSize::expected_triangles() const {
    // An equilateral triangle of side s has 0.433 s^2.
    return sum_over_section(
        [](const SectionPoint&, double size, double area) { return area / (0.433 * size * size); });
}

double LocalSize::expected_tetrahedra(bool revolved, double extent) const {
    // A regular tetrahedron of side s has 0.118 s^3.
    return sum_over_section([&](const SectionPoint& point, double size, double area) {
        const double length = revolved ? extent * point.r : extent;
        return area * length / (0.118 * size * size * size);
    });
}

} // namespace searle::geometry
