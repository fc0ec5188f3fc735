#pragma once

#include "rheometry/tables/column_names.hpp"
#include "rheometry/tables/table_error.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry {

/// A delimited text file: a header line, perhaps a line of units, and rows.
///
/// Read by the rules of RFC 4180 with the delimiter `,` `;` or tab (found from the header line, or
/// from a first line `sep=;`), any line ending, and UTF-8, UTF-16 or Windows-1252 text. Lines that
/// start with # and empty lines are skipped. Every row has as many fields as the header; empty
/// fields at the end of a row are not counted.
class CsvTable {
public:
    /// Throws TableError when the file cannot be read or is not such a table.
    [[nodiscard]] static CsvTable read(const std::filesystem::path& file);
    /// @param name  what messages call the table
    /// @param first_line  of the file where the table starts
    [[nodiscard]] static CsvTable parse(std::string_view bytes, std::string name,
                                        std::size_t first_line = 1);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Headings as in the header, without blanks around them, with the unit line's units.
    [[nodiscard]] const std::vector<Heading>& columns() const { return columns_; }
    [[nodiscard]] char delimiter() const { return delimiter_; }
    [[nodiscard]] std::size_t rows() const { return lines_.size(); }
    /// Line of the file where a row starts, 1-based.
    [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }
    [[nodiscard]] std::size_t header_line() const { return header_line_; }
    /// Index of the column with exactly this name.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view column_name) const;
    [[nodiscard]] std::string_view text(std::size_t row, std::size_t column) const {
        return cells_[row * columns_.size() + column];
    }

private:
    CsvTable() = default;

    std::string name_;
    /// Owns the text that the cells look at; at a fixed address, so that a table can be moved.
    std::unique_ptr<std::string> text_;
    /// Owns quoted cells whose doubled quotes were undone.
    std::deque<std::string> unescaped_;
    std::vector<Heading> columns_;
    std::vector<std::string_view> cells_;
    std::vector<std::size_t> lines_;
    std::size_t header_line_ = 0;
    char delimiter_ = ',';

    friend class CsvReader;
};

} // namespace searle::rheometry
