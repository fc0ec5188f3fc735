#include "rheometry/tables/csv_table.hpp"

#include "rheometry/tables/csv_scanner.hpp"
#include "rheometry/tables/data_units.hpp"
#include "rheometry/tables/file_kind.hpp"
#include "rheometry/tables/number_text.hpp"
#include "rheometry/tables/text_decoding.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace searle::rheometry {
namespace {

[[noreturn]] void fail(const std::string& file, std::size_t line, std::string message) {
    throw TableError(file, {{.line = line, .column = {}, .message = std::move(message)}});
}

std::string_view delimiter_name(char delimiter) {
    return delimiter == '\t' ? "tab" : delimiter == ';' ? "semicolon" : "comma";
}

void drop_empty_end(CsvRecord& record, std::size_t least) {
    while (record.fields.size() > least && trimmed(record.fields.back()).empty())
        record.fields.pop_back();
}

bool is_unit_line(const CsvRecord& record) {
    const bool holds_number = std::ranges::any_of(record.fields, [](std::string_view field) {
        const NumberText::Outcome outcome = read_number(field).outcome;
        return outcome != NumberText::Outcome::empty &&
               outcome != NumberText::Outcome::not_a_number;
    });
    return !holds_number && std::ranges::any_of(record.fields, is_data_unit);
}

/// "sep=;" as the first line, which spreadsheet programs read as the choice of the delimiter.
std::optional<char> take_declared_delimiter(std::string_view& text) {
    if (text.size() < 5 || !text.starts_with("sep="))
        return std::nullopt;
    const char delimiter = text[4];
    const std::size_t line_end = text.find_first_of("\r\n");
    if (line_end != 5 && line_end != std::string_view::npos)
        return std::nullopt;
    if (delimiter != ',' && delimiter != ';' && delimiter != '\t')
        return std::nullopt;
    text.remove_prefix(5);
    return delimiter;
}

} // namespace

/// Builds a table from its text.
class CsvReader {
public:
    CsvReader(std::string text, std::string name, std::size_t first_line)
        : first_line_(first_line) {
        table_.name_ = std::move(name);
        table_.text_ = std::make_unique<std::string>(std::move(text));
    }

    CsvTable table() {
        std::string_view text = *table_.text_;
        const std::optional<char> declared = take_declared_delimiter(text);
        table_.delimiter_ = declared.value_or(delimiter_of(text));
        CsvScanner scanner(text, table_.delimiter_, table_.unescaped_, first_line_);
        try {
            read_header(scanner);
            read_rows(scanner);
        } catch (const std::invalid_argument& error) {
            fail(table_.name_, scanner.line(), error.what());
        }
        return std::move(table_);
    }

private:
    void read_header(CsvScanner& scanner) {
        CsvRecord record;
        if (!scanner.next(record))
            fail(table_.name_, 0, "the file holds no data; a header line and rows are needed");
        drop_empty_end(record, 1);
        table_.header_line_ = record.line;
        const auto is_number = [](std::string_view field) {
            return read_number(field).outcome == NumberText::Outcome::number;
        };
        if (std::ranges::all_of(record.fields, is_number))
            fail(table_.name_, record.line,
                 "the first line holds numbers; it must be the header, with the columns' names");
        if (record.fields.size() == 1)
            refuse_other_delimiter(record);
        for (const std::string_view field : record.fields)
            table_.columns_.push_back({.name = std::string(trimmed(field)), .unit = {}});
        forbid_duplicates(record.line);
    }

    /// A header of one field that something else than a delimiter splits into names.
    void refuse_other_delimiter(const CsvRecord& record) {
        const std::string_view header = trimmed(record.fields.front());
        const std::string_view found = header.find('|') != std::string_view::npos    ? "|"
                                       : header.find("  ") != std::string_view::npos ? "blanks"
                                       : header.find(':') != std::string_view::npos  ? ":"
                                                                                     : "";
        // One blank may be part of a name; next to a name with _ it is none.
        const bool blank = header.find(' ') != std::string_view::npos &&
                           header.find('_') != std::string_view::npos;
        if (!found.empty() || blank)
            fail(
                table_.name_, record.line,
                fmt::format("the header is one field, \"{}\", with {} in it; the delimiter must be "
                            "comma, semicolon or tab",
                            header.substr(0, 60), found.empty() ? "blanks" : found));
    }

    void forbid_duplicates(std::size_t line) {
        TableFaults faults(table_.name_);
        std::unordered_map<std::string_view, std::size_t> first; // a broken header may be wide
        for (std::size_t i = 0; i < table_.columns_.size(); ++i) {
            const std::string& name = table_.columns_[i].name;
            const auto [earlier, is_new] = first.try_emplace(name, i);
            if (!is_new && !name.empty())
                faults.add({.line = line,
                            .column = name,
                            .message = fmt::format("columns {} and {} have the same name; each "
                                                   "name may stand once",
                                                   earlier->second + 1, i + 1)});
        }
        faults.throw_if_any();
    }

    void read_rows(CsvScanner& scanner) {
        const std::size_t width = table_.columns_.size();
        table_.cells_.reserve(table_.text_->size() / 12);
        TableFaults faults(table_.name_);
        CsvRecord record;
        bool first = true;
        while (scanner.next(record)) {
            drop_empty_end(record, width);
            if (std::exchange(first, false) && record.fields.size() <= width &&
                is_unit_line(record)) {
                for (std::size_t i = 0; i < record.fields.size(); ++i)
                    table_.columns_[i].unit = std::string(without_brackets(record.fields[i]));
                continue;
            }
            if (record.fields.size() != width) {
                faults.add(ragged(record));
                continue;
            }
            table_.cells_.insert(table_.cells_.end(), record.fields.begin(), record.fields.end());
            table_.lines_.push_back(record.line);
        }
        faults.throw_if_any();
        if (table_.lines_.empty())
            fail(table_.name_, table_.header_line_, "no rows follow the header line");
    }

    TableFault ragged(const CsvRecord& record) const {
        const std::size_t width = table_.columns_.size();
        std::string message = fmt::format(
            "{} fields, but the header (line {}) has {}; the delimiter is taken to be the {}",
            record.fields.size(), table_.header_line_, width, delimiter_name(table_.delimiter_));
        if (table_.delimiter_ == ',' && record.fields.size() == 2 * width)
            message += "; numbers with decimal commas need ; or tab between the fields, or quotes";
        return {.line = record.line, .column = {}, .message = std::move(message)};
    }

    CsvTable table_;
    std::size_t first_line_;
};

CsvTable CsvTable::parse(std::string_view bytes, std::string name, std::size_t first_line) {
    std::string text;
    try {
        text = decode_text(bytes);
    } catch (const std::invalid_argument& error) {
        fail(name, 0, error.what());
    }
    return CsvReader(std::move(text), std::move(name), first_line).table();
}

CsvTable CsvTable::read(const std::filesystem::path& file) {
    return parse(bytes_of(file), file.string());
}

std::optional<std::size_t> CsvTable::find(std::string_view column_name) const {
    const auto found = std::ranges::find(columns_, column_name, &Heading::name);
    if (found == columns_.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns_.begin());
}

} // namespace searle::rheometry
