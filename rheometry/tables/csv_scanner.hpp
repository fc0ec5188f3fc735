#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry {

/// One line of a delimited text, which may span several lines of the file inside quotes.
struct CsvRecord {
    std::vector<std::string_view> fields;
    std::size_t line{}; ///< of the file, 1-based, where the record starts
};

/// Splits delimited text into records by RFC 4180. Comment lines (first character #) and lines with
/// nothing but blanks are passed over.
class CsvScanner {
public:
    /// @param text       must outlive the fields handed out
    /// @param unescaped  keeps the quoted fields that had doubled quotes in them
    /// @param first_line  of the file where the text starts
    CsvScanner(std::string_view text, char delimiter, std::deque<std::string>& unescaped,
               std::size_t first_line)
        : text_(text), delimiter_(delimiter), unescaped_(unescaped), line_(first_line) {}

    /// Reads the next record; false at the end of the text. Throws std::invalid_argument for a
    /// quote that is never closed, text after a closing quote, or a quote inside an unquoted field;
    /// line() is then the line concerned.
    bool next(CsvRecord& record);
    [[nodiscard]] std::size_t line() const { return line_; }

private:
    void skip_lines_without_data();
    std::string_view quoted_field();
    std::string_view plain_field();
    bool at_line_end() const;
    void pass_line_end();

    std::string_view text_;
    char delimiter_;
    std::deque<std::string>& unescaped_;
    std::size_t position_ = 0;
    std::size_t line_;
};

/// The delimiter of a table, from its first line of data: tab before ; before , whichever the line
/// holds outside quotes.
[[nodiscard]] char delimiter_of(std::string_view text);

} // namespace searle::rheometry
