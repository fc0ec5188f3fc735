#include "geometry/gmsh_module/module.hpp"

#include <gmsh.h>

#include <algorithm>
#include <map>

namespace searle::geometry {
namespace {

std::vector<int> add_outline(const Outline& outline, double scale) {
    const int count = static_cast<int>(outline.points.size());
    std::vector<int> lines;
    for (int at = 0; at < count; ++at) {
        const SectionPoint& point = outline.points[static_cast<std::size_t>(at)];
        gmsh::model::geo::addPoint(point.r / scale, point.z / scale, 0.0, 0.0, at + 1);
    }
    for (int at = 0; at < count; ++at)
        lines.push_back(gmsh::model::geo::addLine(at + 1, (at + 1) % count + 1, at + 1));
    gmsh::model::geo::addPlaneSurface({gmsh::model::geo::addCurveLoop(lines)}, 1);
    gmsh::model::geo::synchronize();
    return lines;
}

std::map<std::size_t, std::uint32_t> take_points(double scale, TriangulationAnswer& answer) {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, true, false);
    std::map<std::size_t, std::uint32_t> number;
    for (std::size_t at = 0; at < tags.size(); ++at)
        if (number.emplace(tags[at], answer.points.size()).second)
            answer.points.push_back({coordinates[3 * at] * scale, coordinates[3 * at + 1] * scale});
    return number;
}

void take_triangles(const std::map<std::size_t, std::uint32_t>& number,
                    TriangulationAnswer& answer) {
    constexpr int triangle_type = 2;
    std::vector<std::size_t> tags;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(triangle_type, tags, nodes);
    for (std::size_t at = 0; at + 2 < nodes.size(); at += 3) {
        std::array<std::uint32_t, 3> triangle{number.at(nodes[at]), number.at(nodes[at + 1]),
                                              number.at(nodes[at + 2])};
        const auto& [a, b, c] = triangle;
        const auto& p = answer.points;
        const double turn =
            (p[b].r - p[a].r) * (p[c].z - p[a].z) - (p[b].z - p[a].z) * (p[c].r - p[a].r);
        if (turn < 0.0)
            std::swap(triangle[1], triangle[2]);
        answer.triangles.push_back(triangle);
    }
}

void take_edges(const Outline& outline, const std::vector<int>& lines,
                const std::map<std::size_t, std::uint32_t>& number, TriangulationAnswer& answer) {
    for (std::size_t edge = 0; edge < lines.size(); ++edge) {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates;
        std::vector<double> parameters;
        gmsh::model::mesh::getNodes(tags, coordinates, parameters, 1, lines[edge], true, true);
        std::vector<std::pair<double, std::uint32_t>> along;
        const SectionPoint& from = outline.start(edge);
        const SectionPoint& to = outline.end(edge);
        for (const std::size_t tag : tags) {
            SectionPoint& point = answer.points[number.at(tag)];
            along.emplace_back((point.r - from.r) * (to.r - from.r) +
                                   (point.z - from.z) * (to.z - from.z),
                               number.at(tag));
        }
        std::sort(along.begin(), along.end());
        std::vector<std::uint32_t> nodes;
        for (const auto& [place, node] : along)
            nodes.push_back(node);
        // The ends and the axis exactly where the outline has them.
        answer.points[nodes.front()] = from;
        answer.points[nodes.back()] = to;
        if (from.r == to.r)
            for (const std::uint32_t node : nodes)
                answer.points[node].r = from.r;
        if (from.z == to.z)
            for (const std::uint32_t node : nodes)
                answer.points[node].z = from.z;
        answer.edge_nodes.push_back(std::move(nodes));
    }
}

} // namespace

void initialise_gmsh() {
    static const bool done = [] {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
        gmsh::option::setNumber("Mesh.Algorithm", 6); // frontal-Delaunay
        gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        return true;
    }();
    (void)done;
}

} // namespace searle::geometry

extern "C" void searle_triangulate(const searle::geometry::TriangulationJob& job,
                                   searle::geometry::TriangulationAnswer& answer) try {
    using namespace searle::geometry;
    initialise_gmsh();
    answer.gmsh_version = GMSH_API_VERSION;
    // Gmsh's tolerances are absolute, so lengths are given in parts of the outline's extent.
    double scale = 0.0;
    for (const SectionPoint& point : job.outline->points)
        scale = std::max({scale, point.r, std::abs(point.z)});
    gmsh::model::add("section");
    const std::vector<int> lines = add_outline(*job.outline, scale);
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) {
        return job.size_at({x * scale, y * scale}) / scale;
    });
    gmsh::model::mesh::generate(2);
    gmsh::model::mesh::removeSizeCallback();
    const auto number = take_points(scale, answer);
    take_triangles(number, answer);
    take_edges(*job.outline, lines, number, answer);
    gmsh::model::remove();
    if (answer.triangles.empty())
        answer.fault = "gmsh made no triangles";
} catch (const std::exception& error) {
    answer.fault = error.what();
} catch (...) {
    std::string message;
    gmsh::logger::getLastError(message);
    answer.fault = message.empty() ? "gmsh failed" : message;
}
