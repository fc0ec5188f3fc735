#include "geometry/unstructured/triangulation.hpp"

#include "geometry/gmsh_module/module.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/unstructured/local_size.hpp"
#include "geometry/unstructured/open_module.hpp"

#include <fmt/format.h>

namespace searle::geometry {
namespace {

void append(const TriangulationAnswer& answer, Mesh& mesh) {
    const auto offset = static_cast<std::uint32_t>(mesh.points.size());
    for (const SectionPoint& point : answer.points)
        mesh.points.push_back({point.r, point.z, 0.0});
    for (const auto& [a, b, c] : answer.triangles)
        mesh.cells.add(CellShape::triangle3, std::array{offset + a, offset + b, offset + c});
}

} // namespace

bool can_triangulate() { return find_gmsh_module_function(triangulate_symbol) != nullptr; }

Mesh triangulated(const std::vector<Outline>& outlines, const TriangleSizes& sizes,
                  std::int64_t most_cells) {
    const auto triangulate =
        reinterpret_cast<TriangulateFunction>(gmsh_module_function(triangulate_symbol));
    double expected = 0.0;
    for (const Outline& outline : outlines)
        expected += LocalSize{outline, sizes}.expected_triangles();
    if (!(expected <= static_cast<double>(most_cells)))
        throw MeshError(fmt::format("about {:.3g} triangles in the section are more than "
                                    "mesh.most_cells allows ({} in the section)",
                                    expected, most_cells));
    Mesh mesh;
    mesh.dimension = 2;
    struct Side {
        std::string patch;
        PatchKind kind;
        std::vector<std::uint32_t> nodes;
    };
    std::vector<Side> sides;
    for (const Outline& outline : outlines) {
        const LocalSize size{outline, sizes};
        TriangulationAnswer answer;
        triangulate({&outline, [&size](const SectionPoint& point) { return size.at(point); }},
                    answer);
        if (!answer.fault.empty())
            throw MeshError(fmt::format("gmsh could not fill the outline: {}", answer.fault));
        const auto offset = static_cast<std::uint32_t>(mesh.points.size());
        append(answer, mesh);
        for (std::size_t edge = 0; edge < outline.edges.size(); ++edge) {
            for (std::uint32_t& node : answer.edge_nodes[edge])
                node += offset;
            sides.push_back({outline.edges[edge].patch, outline.edges[edge].kind,
                             std::move(answer.edge_nodes[edge])});
        }
    }
    for (const Side& first : sides) {
        if (mesh.patch(first.patch) != nullptr)
            continue;
        Patch patch{.name = first.patch, .kind = first.kind, .first = mesh.faces.size()};
        for (const Side& side : sides)
            for (std::size_t node = 0; side.patch == first.patch && node + 1 < side.nodes.size();
                 ++node)
                mesh.faces.add(CellShape::line2,
                               std::array{side.nodes[node], side.nodes[node + 1]});
        patch.count = mesh.faces.size() - patch.first;
        mesh.patches.push_back(std::move(patch));
    }
    return mesh;
}

} // namespace searle::geometry
