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

/// What meshio 5 writes and reads again from mixed meshes with numbered or named patches, apart
/// from the formats written here.
constexpr std::array meshio_endings{".xdmf", ".xmf",   ".inp", ".su2", ".med",
                                    ".mesh", ".meshb", ".bdf", ".nas", ".fem",
                                    ".avs",  ".vol",   ".e",   ".exo", ".ex2"};

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
        break;
    }
}

std::vector<std::string> losses_of(const Mesh& mesh, MeshFormat format) {
    std::vector<std::string> losses;
    if (format == MeshFormat::stl)
        losses.emplace_back("an .stl file holds the boundary alone, in triangles");
    const bool is_vtk = format == MeshFormat::vtu || format == MeshFormat::vtk;
    if ((is_vtk || format == MeshFormat::meshio) && !mesh.periodic_points.empty())
        losses.emplace_back("the pairs of periodic points are in .msh and OpenFOAM meshes alone");
    return losses;
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

std::vector<std::string> write_mesh(const Mesh& mesh, const fs::path& path, MeshFormat format) {
    std::vector<std::string> losses = losses_of(mesh, format);
    if (format == MeshFormat::meshio) {
        const std::vector<std::string> more = write_by_meshio(mesh, path);
        losses.insert(losses.end(), more.begin(), more.end());
        return losses;
    }
    if (format == MeshFormat::openfoam) {
        write_openfoam(mesh, path);
        return losses;
    }
    // Beside the target, so that no reader ever meets half a mesh.
    fs::path part = path;
    part += fmt::format(".part-{}", getpid());
    std::error_code ignored;
    try {
        write_as(mesh, part, format);
        fs::rename(part, path);
    } catch (const fs::filesystem_error& error) {
        fs::remove(part, ignored);
        throw fs::filesystem_error("the mesh cannot be written", path, error.code());
    } catch (...) {
        fs::remove(part, ignored);
        throw;
    }
    return losses;
}

} // namespace searle::geometry
