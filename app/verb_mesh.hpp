#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct MeshOptions {
    std::filesystem::path case_file;
    std::filesystem::path output;                 ///< its ending is the format; a folder: OpenFOAM
    std::vector<std::string> overrides;           ///< "key=value" texts of --set
    std::string format;                           ///< "msh22" for gmsh 2.2; empty: by the ending
    std::optional<std::filesystem::path> preview; ///< .svg or .png: cells and patches
    std::optional<std::filesystem::path> drawing; ///< .svg or .png: dimensions
    bool json = false;
    bool quiet = false;
};

/// `searle mesh CASE.toml -o FILE`: writes the mesh and prints its checks to stdout.
/// Returns the exit code: done, or not_reached for a mesh that was written and has faults. Throws
/// CaseError, geometry::MeshError, geometry::MeshToolMissing and std::filesystem::filesystem_error.
[[nodiscard]] int mesh(const MeshOptions& options);

} // namespace searle::app
