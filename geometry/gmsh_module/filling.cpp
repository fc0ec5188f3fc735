#include "geometry/gmsh_module/module.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace searle::geometry {
namespace {

/// Distance of a point of the section from an edge of the outline.
double distance_to(const SectionPoint& point, const SectionPoint& from, const SectionPoint& to) {
    const double dr = to.r - from.r;
    const double dz = to.z - from.z;
    const double along = ((point.r - from.r) * dr + (point.z - from.z) * dz) / (dr * dr + dz * dz);
    const double part = std::clamp(along, 0.0, 1.0);
    return std::hypot(point.r - from.r - part * dr, point.z - from.z - part * dz);
}

class Filling {
public:
    Filling(const FillingJob& job, FillingAnswer& answer) : job_{job}, answer_{answer} {
        for (const SectionPoint& point : job.outline->points)
            scale_ = std::max({scale_, point.r, std::abs(point.z)});
    }

    void run() {
        gmsh::model::add("solid");
        add_solid();
        gmsh::model::mesh::setSizeCallback([this](int, int, double x, double y, double z) {
            return job_.size_at(section_of({x * scale_, y * scale_, z * scale_})) / scale_;
        });
        gmsh::model::mesh::generate(3);
        gmsh::model::mesh::removeSizeCallback();
        take_points();
        take_tetrahedra();
        take_surfaces();
        gmsh::model::remove();
    }

private:
    [[nodiscard]] SectionPoint section_of(const Point& point) const {
        return job_.revolved ? SectionPoint{std::hypot(point.x, point.y), point.z}
                             : SectionPoint{point.y, point.z};
    }

    /// The section at the front, swept to the back; lengths in parts of the outline's extent, since
    /// gmsh's tolerances are absolute.
    void add_solid() {
        namespace occ = gmsh::model::occ;
        const double start = job_.closed ? 0.0 : -0.5 * job_.extent;
        const auto& points = job_.outline->points;
        const int count = static_cast<int>(points.size());
        std::vector<int> lines;
        for (int at = 0; at < count; ++at) {
            const SectionPoint& point = points[static_cast<std::size_t>(at)];
            const double r = point.r / scale_;
            const double z = point.z / scale_;
            if (job_.revolved)
                occ::addPoint(r * std::cos(start), r * std::sin(start), z, 0.0, at + 1);
            else
                occ::addPoint(job_.extent / scale_, r, z, 0.0, at + 1);
        }
        for (int at = 0; at < count; ++at)
            lines.push_back(occ::addLine(at + 1, (at + 1) % count + 1, at + 1));
        const int section = occ::addPlaneSurface({occ::addCurveLoop(lines)});
        gmsh::vectorpair swept;
        if (job_.revolved)
            occ::revolve({{2, section}}, 0, 0, 0, 0, 0, 1, job_.extent, swept);
        else
            occ::extrude({{2, section}}, -job_.extent / scale_, 0, 0, swept);
        if (job_.closed) // the section is inside, no end
            occ::remove({{2, section}}, true);
        occ::synchronize();
        if (job_.closed)
            return;
        // The first of what a sweep makes is the far end.
        const double c = std::cos(job_.extent);
        const double s = std::sin(job_.extent);
        const std::vector<double> map =
            job_.revolved ? std::vector<double>{c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}
                          : std::vector<double>{
                                1, 0, 0, -job_.extent / scale_, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        front_ = section;
        back_ = swept.front().second;
        gmsh::model::mesh::setPeriodic(2, {back_}, {front_}, map);
    }

    void take_points() {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates;
        std::vector<double> parameters;
        gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, true, false);
        for (std::size_t at = 0; at < tags.size(); ++at)
            if (number_.emplace(tags[at], answer_.points.size()).second)
                answer_.points.push_back({coordinates[3 * at] * scale_,
                                          coordinates[3 * at + 1] * scale_,
                                          coordinates[3 * at + 2] * scale_});
    }

    void take_tetrahedra() {
        constexpr int tetrahedron = 4;
        std::vector<std::size_t> tags;
        std::vector<std::size_t> nodes;
        gmsh::model::mesh::getElementsByType(tetrahedron, tags, nodes);
        for (std::size_t at = 0; at + 3 < nodes.size(); at += 4)
            answer_.tetrahedra.push_back({number_.at(nodes[at]), number_.at(nodes[at + 1]),
                                          number_.at(nodes[at + 2]), number_.at(nodes[at + 3])});
    }

    [[nodiscard]] FillingAnswer::Triangles triangles_on(int surface) const {
        constexpr int triangle = 2;
        std::vector<std::size_t> tags;
        std::vector<std::size_t> nodes;
        gmsh::model::mesh::getElementsByType(triangle, tags, nodes, surface);
        FillingAnswer::Triangles triangles;
        for (std::size_t at = 0; at + 2 < nodes.size(); at += 3)
            triangles.push_back(
                {number_.at(nodes[at]), number_.at(nodes[at + 1]), number_.at(nodes[at + 2])});
        return triangles;
    }

    /// The edge of the outline that all points of a surface lie on.
    [[nodiscard]] std::size_t edge_of(const FillingAnswer::Triangles& triangles) const {
        const Outline& outline = *job_.outline;
        std::size_t best = 0;
        double least = -1.0;
        for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
            double farthest = 0.0;
            for (const auto& triangle : triangles)
                for (const std::uint32_t node : triangle)
                    farthest =
                        std::max(farthest, distance_to(section_of(answer_.points[node]),
                                                       outline.start(edge), outline.end(edge)));
            if (least < 0.0 || farthest < least) {
                least = farthest;
                best = edge;
            }
        }
        if (!(least < 1e-5 * scale_))
            answer_.fault = "a surface lies on no edge of the outline";
        return best;
    }

    void take_surfaces() {
        answer_.edge_faces.resize(job_.outline->edges.size());
        gmsh::vectorpair surfaces;
        gmsh::model::getEntities(surfaces, 2);
        for (const auto& [dimension, surface] : surfaces) {
            FillingAnswer::Triangles triangles = triangles_on(surface);
            if (surface == front_) {
                answer_.front = std::move(triangles);
                continue;
            }
            if (surface == back_) {
                take_pairs();
                continue;
            }
            auto& faces = answer_.edge_faces[edge_of(triangles)];
            faces.insert(faces.end(), triangles.begin(), triangles.end());
        }
    }

    void take_pairs() {
        int master = 0;
        std::vector<std::size_t> back;
        std::vector<std::size_t> front;
        std::vector<double> map;
        gmsh::model::mesh::getPeriodicNodes(2, back_, master, back, front, map);
        for (std::size_t at = 0; at < back.size(); ++at)
            answer_.pairs.push_back({number_.at(front[at]), number_.at(back[at])});
    }

    const FillingJob& job_;
    FillingAnswer& answer_;
    double scale_ = 0.0;
    int front_ = 0;
    int back_ = 0;
    std::map<std::size_t, std::uint32_t> number_;
};

} // namespace
} // namespace searle::geometry

extern "C" void searle_fill(const searle::geometry::FillingJob& job,
                            searle::geometry::FillingAnswer& answer) try {
    using namespace searle::geometry;
    initialise_gmsh();
    Filling{job, answer}.run();
    if (answer.tetrahedra.empty())
        answer.fault = "gmsh made no tetrahedra";
    else if (!job.closed && answer.pairs.empty())
        answer.fault = "gmsh's two ends do not match";
} catch (const std::exception& error) {
    answer.fault = error.what();
} catch (...) {
    std::string message;
    gmsh::logger::getLastError(message);
    answer.fault = message.empty() ? "gmsh failed" : message;
}
