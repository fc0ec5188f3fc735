#pragma once

#include "rheometry/tables/spreadsheet.hpp"

#include <string>

namespace searle::rheometry {

/// A sheet as tab-delimited text, a line per row, so that whatever reads such text reads sheets.
/// Line breaks within a cell become blanks; numbers keep 17 significant digits.
[[nodiscard]] std::string tab_delimited(const Sheet& sheet);

} // namespace searle::rheometry
