#pragma once

#include "app/result_folder.hpp"
#include "rheometry/fields/section_fields.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

/// fields/row-0001.vtu and so on, and fields/rows.pvd, which lists them by time; nothing without
/// fields.
[[nodiscard]] std::vector<ResultFile>
field_files(const std::vector<rheometry::fields::SectionFields>& fields);

/// The names of these files.
[[nodiscard]] std::vector<std::string>
field_file_names(const std::vector<rheometry::fields::SectionFields>& fields);

/// Reads the .vtu files of fields/ among those that a summary lists. Throws std::runtime_error that
/// names the file.
[[nodiscard]] std::vector<rheometry::fields::SectionFields>
read_field_files(const std::filesystem::path& folder, const std::vector<std::string>& listed);

} // namespace searle::app
