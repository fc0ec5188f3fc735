#include "geometry/outline_check.hpp"

#include "geometry/mesh_error.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/squared_distance_2.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace searle::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlanePoint = Kernel::Point_2;
using Segment = Kernel::Segment_2;

std::string described(const Outline& outline, std::size_t edge) {
    const OutlineEdge& it = outline.edges[edge];
    const auto& from = outline.start(edge);
    const auto& to = outline.end(edge);
    return fmt::format("{} from (r, z) = ({:.6g}, {:.6g}) mm to ({:.6g}, {:.6g}) mm",
                       it.label.empty() ? it.patch : it.label, from.r * 1e3, from.z * 1e3,
                       to.r * 1e3, to.z * 1e3);
}

bool neighbours(std::size_t one, std::size_t other, std::size_t count) {
    return (one + 1) % count == other || (other + 1) % count == one;
}

/// Neighbours meet in one point; more than that is an edge that folds back on the other.
bool folds_back(const Segment& one, const Segment& next) {
    return CGAL::collinear(one.source(), one.target(), next.target()) &&
           !CGAL::collinear_are_ordered_along_line(one.source(), one.target(), next.target());
}

void check_points(const Outline& outline) {
    for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
        const auto& [r, z] = outline.start(edge);
        if (!std::isfinite(r) || !std::isfinite(z) || r < 0.0)
            throw MeshError(fmt::format("the outline leaves the half plane r >= 0: {}",
                                        described(outline, edge)));
        const auto& end = outline.end(edge);
        if (r == end.r && z == end.z)
            throw MeshError(fmt::format("the outline has an edge without length: {}",
                                        described(outline, edge)));
    }
    if (outline.edges.size() < 3)
        throw MeshError("the outline has fewer than three edges");
}

} // namespace

bool is_rotor_patch(std::string_view patch) {
    return patch.starts_with("bob") || patch.starts_with("shaft") || patch.starts_with("rotor");
}

OutlineFindings check_outline(const Outline& outline) {
    check_points(outline);
    const std::size_t count = outline.edges.size();
    std::vector<PlanePoint> points;
    std::vector<Segment> segments;
    for (const SectionPoint& point : outline.points)
        points.emplace_back(point.r, point.z);
    for (std::size_t edge = 0; edge < count; ++edge)
        segments.emplace_back(points[edge], points[(edge + 1) % count]);

    OutlineFindings findings{std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
    for (std::size_t one = 0; one < count; ++one) {
        findings.smallest_feature =
            std::min(findings.smallest_feature, std::sqrt(segments[one].squared_length()));
        for (std::size_t other = one + 1; other < count; ++other) {
            const bool adjacent = neighbours(one, other, count);
            const bool faulty =
                adjacent ? (one + 1 == other ? folds_back(segments[one], segments[other])
                                             : folds_back(segments[other], segments[one]))
                         : CGAL::do_intersect(segments[one], segments[other]);
            if (faulty)
                throw MeshError(fmt::format("the outline crosses or touches itself:\n  {}\n  {}",
                                            described(outline, one), described(outline, other)));
            if (adjacent)
                continue;
            const double distance =
                std::sqrt(CGAL::squared_distance(segments[one], segments[other]));
            findings.smallest_feature = std::min(findings.smallest_feature, distance);
            const bool are_walls = outline.edges[one].kind == PatchKind::wall &&
                                   outline.edges[other].kind == PatchKind::wall;
            if (are_walls && is_rotor_patch(outline.edges[one].patch) !=
                                 is_rotor_patch(outline.edges[other].patch))
                findings.clearance = std::min(findings.clearance, distance);
        }
    }
    if (CGAL::orientation_2(points.begin(), points.end(), Kernel()) != CGAL::COUNTERCLOCKWISE)
        throw MeshError("the outline turns clockwise: the rotor lies outside the cup");
    return findings;
}

} // namespace searle::geometry
