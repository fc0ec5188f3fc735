#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace searle::solvers::openfoam {

/// An OpenFOAM that can be run.
struct Installation {
    std::filesystem::path project; ///< what WM_PROJECT_DIR must be: holds etc/controlDict
    std::string version;           ///< as its own settings say, e.g. "v1912"; empty: unknown
};

/// The version that this program's cases are written for and were checked with.
inline constexpr std::string_view supported_version = "v1912";

/// Debian's package that holds it.
inline constexpr std::string_view package = "openfoam";
/// Debian's package that holds mpirun.
inline constexpr std::string_view mpi_package = "openmpi-bin";

/// What to beware of with this installation: a sentence where its version is another than the
/// supported one, or unknown; else empty.
[[nodiscard]] std::string doubt_about(const Installation& installation);

/// The first program of that name in PATH.
[[nodiscard]] std::optional<std::filesystem::path> program_in_path(std::string_view program);

/// OpenFOAM: WM_PROJECT_DIR where that is set, else where Debian's package puts it. Nothing where
/// its settings or the program `pimpleFoam` are missing.
[[nodiscard]] std::optional<Installation> find_installation();

} // namespace searle::solvers::openfoam
