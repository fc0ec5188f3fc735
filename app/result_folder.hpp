#pragma once

#include "app/output_place.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::app {

/// A file of a result folder.
struct ResultFile {
    std::string name; ///< relative to the folder; '/' separates subfolders
    std::string content;
};

/// Writing failed midway (full disk, ...); what was written has been removed again.
/// The program's exit code for it is 1.
struct OutputWriteError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes a result folder that appears as a whole: the files go to a hidden folder beside it, and
/// that is renamed at the end, so that no reader ever meets half a result; results that stood there
/// are removed only after that. Missing parents are made. A folder that cannot be renamed (a mount
/// point, the current directory) gets its files one after the other, summary.json last.
/// @param replace  see check_output_place
/// Throws OutputPlaceError as check_output_place does, and OutputWriteError.
void write_result_folder(const std::filesystem::path& folder, const std::vector<ResultFile>& files,
                         bool replace);

/// Replaces one file as a whole, by way of a file beside it. Throws OutputWriteError.
void replace_file(const std::filesystem::path& file, const std::string& content);

} // namespace searle::app
