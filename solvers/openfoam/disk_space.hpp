#pragma once

#include <filesystem>
#include <stdexcept>

namespace searle::solvers::openfoam {

/// OpenFOAM had no room to write. What stands in the folder is kept, and a later run goes on there.
struct DiskFull : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether the file system of a folder is as good as full: OpenFOAM does not say so itself, it ends
/// in some error or goes on without its files.
[[nodiscard]] bool disk_is_full(const std::filesystem::path& folder);

} // namespace searle::solvers::openfoam
