#pragma once

#include "geometry/mesh.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::geometry {

enum class MeshFormat {
    msh41,    ///< gmsh 4.1
    msh22,    ///< gmsh 2.2
    vtu,      ///< VTK's XML file, raw binary
    vtk,      ///< VTK's legacy file, text
    stl,      ///< the boundary in triangles, a solid a patch
    openfoam, ///< a folder that gets constant/polyMesh
    meshio    ///< any other ending that meshio knows
};

/// The format for a path: by its ending, or OpenFOAM for a folder (a path that ends in '/', or a
/// folder that exists). No value: an unknown ending.
[[nodiscard]] std::optional<MeshFormat> format_of(const std::filesystem::path& path);

/// The endings that can be written, for messages.
[[nodiscard]] std::vector<std::string> known_endings();

/// Writes the mesh; a file appears as a whole. `format` msh22 overrides the default for ".msh".
/// Gives what the format does not hold of the mesh, a sentence each.
/// Throws MeshError where the format cannot hold the mesh, MeshToolMissing for a missing meshio,
/// std::filesystem::filesystem_error where the path cannot be written.
std::vector<std::string> write_mesh(const Mesh& mesh, const std::filesystem::path& path,
                                    MeshFormat format);

// One writer a format; each writes to the path given.
void write_msh22(const Mesh& mesh, const std::filesystem::path& file);
void write_msh41(const Mesh& mesh, const std::filesystem::path& file);
void write_vtu(const Mesh& mesh, const std::filesystem::path& file);
void write_vtk(const Mesh& mesh, const std::filesystem::path& file);
void write_stl(const Mesh& mesh, const std::filesystem::path& file);
/// @param folder  the case's folder; constant/polyMesh is made in it
void write_openfoam(const Mesh& mesh, const std::filesystem::path& folder);
/// Reads the file back by meshio and compares; gives what it does not hold.
[[nodiscard]] std::vector<std::string> write_by_meshio(const Mesh& mesh,
                                                       const std::filesystem::path& file);

} // namespace searle::geometry
