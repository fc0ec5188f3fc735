#include "geometry/mesh_format/write_mesh.hpp"

#include "geometry/mesh_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>
#include <unistd.h>

namespace searle::geometry {
namespace {

namespace fs = std::filesystem;

/// What meshio 5 writes from mixed meshes, apart from the formats written here.
constexpr std::array meshio_endings{
    ".xdmf", ".xmf",  ".inp", ".su2",  ".mesh",   ".meshb", ".bdf", ".fem",  ".nas", ".med",
    ".e",    ".exo",  ".ex2", ".cgns", ".h5m",    ".ugrid", ".avs", ".mdpa", ".xml", ".vol",
    ".post", ".dato", ".dat", ".tec",  ".f3grid", ".off",   ".obj", ".ply"};

void write_as(const Mesh& mesh, const fs::path& path, MeshFormat format) {
    switch (format) {
    case MeshFormat::msh41:
        return write_msh41(mesh, path);
    case MeshFormat::msh22:
        return write_msh22(mesh, path);
    case MeshFormat::vtu:
        return write_vtu(mesh, path);
    case MeshFormat::vtk:
        return write_vtk(mesh, path);
    case MeshFormat::stl:
        return write_stl(mesh, path);
    case MeshFormat::openfoam:
        return write_openfoam(mesh, path);
    case MeshFormat::meshio:
        return write_by_meshio(mesh, path);
    }
}

} // namespace

std::optional<MeshFormat> format_of(const fs::path& path) {
    std::error_code ignored;
    if (!path.has_filename() || fs::is_directory(path, ignored))
        return MeshFormat::openfoam;
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (ending == ".msh")
        return MeshFormat::msh41;
    if (ending == ".vtu")
        return MeshFormat::vtu;
    if (ending == ".vtk")
        return MeshFormat::vtk;
    if (ending == ".stl")
        return MeshFormat::stl;
    if (std::find(meshio_endings.begin(), meshio_endings.end(), ending) != meshio_endings.end())
        return MeshFormat::meshio;
    return std::nullopt;
}

std::vector<std::string> known_endings() {
    std::vector<std::string> endings{".msh", ".vtu", ".vtk", ".stl"};
    endings.insert(endings.end(), meshio_endings.begin(), meshio_endings.end());
    return endings;
}

void write_mesh(const Mesh& mesh, const fs::path& path, MeshFormat format) {
    if (format == MeshFormat::openfoam || format == MeshFormat::meshio)
        return write_as(mesh, path, format);
    // Beside the target, so that no reader ever meets half a mesh.
    fs::path part = path;
    part += fmt::format(".part-{}", getpid());
    try {
        write_as(mesh, part, format);
        fs::rename(part, path);
    } catch (...) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw;
    }
}

} // namespace searle::geometry
