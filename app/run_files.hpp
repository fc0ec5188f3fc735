#pragma once

#include "app/report_page.hpp"
#include "app/result_folder.hpp"
#include "app/solved_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

/// What the files of a solved case's result folder hold, the report apart.
[[nodiscard]] RunRecord record_of(const SolvedCase& solved, const std::string& created);

/// The files of a run's result folder, the report included.
/// @param prefix  in front of every name: "" or "subfolder/"
[[nodiscard]] std::vector<ResultFile> files_of(const RunRecord& record, const std::string& prefix);

/// Reads a run's result folder again. Throws std::runtime_error that names the file when one is
/// missing or was changed so that it cannot be read.
[[nodiscard]] RunRecord read_record(const std::filesystem::path& folder);

/// The whole text of a file. Throws std::runtime_error that names it.
[[nodiscard]] std::string text_of_file(const std::filesystem::path& file);

} // namespace searle::app
