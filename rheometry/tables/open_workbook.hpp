#pragma once

#include "rheometry/tables/spreadsheet.hpp"

#include <filesystem>
#include <vector>

namespace searle::rheometry {

/// Reads the sheets of an Office Open XML workbook (.xlsx; ECMA-376, SpreadsheetML): numbers and
/// texts as they are stored, of formulas the value stored last; formats, also of dates, are left
/// out. Throws TableError for a file that is missing or damaged, no workbook, or beyond 512 MiB of
/// text or 20 million cells.
[[nodiscard]] std::vector<Sheet> read_open_workbook(const std::filesystem::path& file);

} // namespace searle::rheometry
