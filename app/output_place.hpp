#pragma once

#include <filesystem>
#include <stdexcept>

namespace searle::app {

/// The place asked for cannot take results: it is a file, holds something already, ...
/// Nothing was touched. The program's exit code for it is 2.
struct OutputPlaceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What stands where a result folder is to be.
enum class Occupant {
    nothing,
    empty_folder,
    results ///< a result folder that holds nothing but what its summary.json lists
};

/// Sees whether results can go to `folder`, without touching anything.
/// @param replace  results that stand there may be replaced. A folder that holds anything which the
///                 results' own summary.json does not list is refused all the same.
/// Throws OutputPlaceError.
Occupant check_output_place(const std::filesystem::path& folder, bool replace);

/// The folder's absolute path without '.', '..' and links, as far as it exists.
[[nodiscard]] std::filesystem::path settled_path(const std::filesystem::path& folder);

} // namespace searle::app
