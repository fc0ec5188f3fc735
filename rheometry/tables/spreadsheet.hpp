#pragma once

#include "rheometry/tables/table_error.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace searle::rheometry {

/// A cell's number or text; neither when it is empty.
using SheetCell = std::variant<std::monostate, double, std::string>;

struct Sheet {
    std::string name;
    std::size_t rows{};
    std::size_t columns{};
    std::vector<SheetCell> cells; ///< row by row

    [[nodiscard]] const SheetCell& cell(std::size_t row, std::size_t column) const {
        return cells[row * columns + column];
    }
    /// The cell's text, empty when it is no text or outside of the sheet.
    [[nodiscard]] std::string_view text(std::size_t row, std::size_t column) const;
};

/// Cells of a workbook's sheets.
struct CellCount {
    std::size_t all = 0;
    std::size_t filled = 0; ///< those that hold anything
};

/// Whether so many cells are empty that the workbook must be damaged: a small file would fill the
/// memory with them.
[[nodiscard]] constexpr bool is_too_sparse(const CellCount& cells) {
    return cells.all > 2'000'000 + 50 * cells.filled;
}

/// Reads the sheets of a binary workbook (.xls, BIFF). The library that does it runs in a process
/// of its own, so that a damaged file cannot take the program down. Throws TableError for a file
/// that is missing, damaged, protected by a password, or no such workbook.
[[nodiscard]] std::vector<Sheet> read_spreadsheet(const std::filesystem::path& file);

/// Version of the library that reads spreadsheets (FreeXL).
[[nodiscard]] std::string spreadsheet_library_version();

} // namespace searle::rheometry
