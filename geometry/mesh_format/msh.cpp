// Format: gmsh's manual, "MSH file format" 4.1 and "MSH file format version 2 (Legacy)".

#include "geometry/mesh_format/gmsh_numbers.hpp"
#include "geometry/mesh_format/text_stream.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace searle::geometry {
namespace {

void write_names(const Mesh& mesh, TextStream& out) {
    // Patch n is the physical group and the entity n; the fluid follows them.
    out << "$PhysicalNames\n" << mesh.patches.size() + 1 << '\n';
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        out << mesh.dimension - 1 << ' ' << patch + 1 << " \"" << mesh.patches[patch].name
            << "\"\n";
    out << mesh.dimension << ' ' << mesh.patches.size() + 1 << " \"fluid\"\n$EndPhysicalNames\n";
}

/// Affine map from the front of a periodic pair to its back, row by row.
std::array<double, 16> affine_of(const PeriodicMap& map) {
    const double c = std::cos(map.angle);
    const double s = std::sin(map.angle);
    return {c, -s, 0, map.shift.x, s, c, 0, map.shift.y, 0, 0, 1, map.shift.z, 0, 0, 0, 1};
}

/// `extra` is what stands between the affine line and the number of pairs: nothing.
void write_periodic(const Mesh& mesh, TextStream& out, bool counts_affine) {
    if (mesh.periodic_points.empty())
        return;
    std::size_t front = 0;
    std::size_t back = 0;
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
        if (mesh.patches[patch].name == "periodic_front")
            front = patch + 1;
        if (mesh.patches[patch].name == "periodic_back")
            back = patch + 1;
    }
    out << "$Periodic\n1\n" << mesh.dimension - 1 << ' ' << back << ' ' << front << '\n';
    out << (counts_affine ? "16" : "Affine");
    for (const double entry : affine_of(mesh.periodic_map))
        out << ' ' << entry;
    out << '\n' << mesh.periodic_points.size() << '\n';
    for (const auto& [at_front, at_back] : mesh.periodic_points)
        out << at_back + 1 << ' ' << at_front + 1 << '\n';
    out << "$EndPeriodic\n";
}

void write_numbers(std::span<const std::uint32_t> nodes, TextStream& out) {
    for (const std::uint32_t node : nodes)
        out << ' ' << node + 1;
    out << '\n';
}

/// Runs of elements of one shape, as gmsh 4.1 groups them.
struct Run {
    int dimension;
    std::size_t entity;
    CellShape shape;
    const ElementList* elements;
    std::vector<std::size_t> members;
};

std::vector<Run> runs_of(const Mesh& mesh) {
    std::vector<Run> runs;
    const auto gather = [&runs](int dimension, std::size_t entity, const ElementList& elements,
                                std::size_t first, std::size_t count) {
        std::map<CellShape, std::vector<std::size_t>> by_shape;
        for (std::size_t at = first; at < first + count; ++at)
            by_shape[elements.shape(at)].push_back(at);
        for (auto& [shape, members] : by_shape)
            runs.push_back({dimension, entity, shape, &elements, std::move(members)});
    };
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        gather(mesh.dimension - 1, patch + 1, mesh.faces, mesh.patches[patch].first,
               mesh.patches[patch].count);
    gather(mesh.dimension, mesh.patches.size() + 1, mesh.cells, 0, mesh.cells.size());
    return runs;
}

void write_entities(const Mesh& mesh, TextStream& out) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::array<double, 6> box{infinite, infinite, infinite, -infinite, -infinite, -infinite};
    for (const Point& point : mesh.points) {
        const std::array<double, 3> at{point.x, point.y, point.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box[axis] = std::min(box[axis], at[axis]);
            box[axis + 3] = std::max(box[axis + 3], at[axis]);
        }
    }
    const auto bounds = [&] {
        for (const double side : box)
            out << ' ' << side;
    };
    out << "$Entities\n";
    std::array<std::size_t, 4> counts{};
    counts[static_cast<std::size_t>(mesh.dimension - 1)] = mesh.patches.size();
    counts[static_cast<std::size_t>(mesh.dimension)] = 1;
    out << counts[0] << ' ' << counts[1] << ' ' << counts[2] << ' ' << counts[3] << '\n';
    for (std::size_t patch = 1; patch <= mesh.patches.size(); ++patch) {
        out << patch;
        bounds();
        out << " 1 " << patch << " 0\n";
    }
    out << mesh.patches.size() + 1;
    bounds();
    out << " 1 " << mesh.patches.size() + 1 << ' ' << mesh.patches.size();
    for (std::size_t patch = 1; patch <= mesh.patches.size(); ++patch)
        out << ' ' << patch;
    out << "\n$EndEntities\n";
}

} // namespace

void write_msh22(const Mesh& mesh, const std::filesystem::path& file) {
    TextStream out{file};
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names(mesh, out);
    out << "$Nodes\n" << mesh.points.size() << '\n';
    for (std::size_t at = 0; at < mesh.points.size(); ++at)
        out << at + 1 << ' ' << mesh.points[at].x << ' ' << mesh.points[at].y << ' '
            << mesh.points[at].z << '\n';
    out << "$EndNodes\n$Elements\n" << mesh.faces.size() + mesh.cells.size() << '\n';
    std::size_t number = 1;
    const auto write = [&](const ElementList& elements, std::size_t at, std::size_t group) {
        out << number++ << ' ' << gmsh_type(elements.shape(at)) << " 2 " << group << ' ' << group;
        write_numbers(elements.nodes(at), out);
    };
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        for (std::size_t face = 0; face < mesh.patches[patch].count; ++face)
            write(mesh.faces, mesh.patches[patch].first + face, patch + 1);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        write(mesh.cells, cell, mesh.patches.size() + 1);
    out << "$EndElements\n";
    write_periodic(mesh, out, false);
    out.close();
}

void write_msh41(const Mesh& mesh, const std::filesystem::path& file) {
    TextStream out{file};
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_names(mesh, out);
    write_entities(mesh, out);
    const std::size_t points = mesh.points.size();
    out << "$Nodes\n1 " << points << " 1 " << points << '\n';
    out << mesh.dimension << ' ' << mesh.patches.size() + 1 << " 0 " << points << '\n';
    for (std::size_t at = 1; at <= points; ++at)
        out << at << '\n';
    for (const Point& point : mesh.points)
        out << point.x << ' ' << point.y << ' ' << point.z << '\n';
    const std::vector<Run> runs = runs_of(mesh);
    const std::size_t elements = mesh.faces.size() + mesh.cells.size();
    out << "$EndNodes\n$Elements\n" << runs.size() << ' ' << elements << " 1 " << elements << '\n';
    std::size_t number = 1;
    for (const Run& run : runs) {
        out << run.dimension << ' ' << run.entity << ' ' << gmsh_type(run.shape) << ' '
            << run.members.size() << '\n';
        for (const std::size_t member : run.members) {
            out << number++;
            write_numbers(run.elements->nodes(member), out);
        }
    }
    out << "$EndElements\n";
    write_periodic(mesh, out, true);
    out.close();
}

} // namespace searle::geometry
