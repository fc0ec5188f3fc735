#include "geometry/unstructured/triangulation.hpp"

#include "geometry/gmsh_module/module.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/unstructured/local_size.hpp"

#include <fmt/format.h>

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace searle::geometry {
namespace {

namespace fs = std::filesystem;

/// Beside the program, or where it was built.
void* open_module() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path beside = program.parent_path() / "searle_gmsh.so";
    for (const fs::path& path : {beside, fs::path{SEARLE_GMSH_MODULE}})
        if (fs::exists(path, ignored))
            if (void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
                return module;
    return nullptr;
}

/// Null: gmsh is not here.
TriangulateFunction loaded_function() {
    static const auto function = [] {
        void* const module = open_module();
        return module == nullptr
                   ? nullptr
                   : reinterpret_cast<TriangulateFunction>(dlsym(module, triangulate_symbol));
    }();
    return function;
}

TriangulateFunction triangulate_function() {
    const TriangulateFunction function = loaded_function();
    if (function == nullptr)
        throw MeshToolMissing("triangles are made by gmsh, which is not here; to get it: apt-get "
                              "install libgmsh-dev, and build Searle again");
    return function;
}

void append(const TriangulationAnswer& answer, Mesh& mesh) {
    const auto offset = static_cast<std::uint32_t>(mesh.points.size());
    for (const SectionPoint& point : answer.points)
        mesh.points.push_back({point.r, point.z, 0.0});
    for (const auto& [a, b, c] : answer.triangles)
        mesh.cells.add(CellShape::triangle3, std::array{offset + a, offset + b, offset + c});
}

} // namespace

bool can_triangulate() { return loaded_function() != nullptr; }

Mesh triangulated(const std::vector<Outline>& outlines, const TriangleSizes& sizes,
                  std::int64_t most_cells) {
    const TriangulateFunction triangulate = triangulate_function();
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
