#include "rheometry/tables/flow_curves.hpp"

#include "rheometry/tables/column_names.hpp"
#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/file_kind.hpp"
#include "rheometry/tables/flow_curve_blocks.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "rheometry/tables/number_columns.hpp"
#include "rheometry/tables/sheet_text.hpp"
#include "rheometry/tables/text_decoding.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace searle::rheometry {
namespace {

namespace fs = std::filesystem;

std::vector<double> column(const CsvTable& table, NumberColumns& numbers, ColumnQuantity quantity) {
    TableFaults of_heading(table.name());
    const auto match = find_column(table.columns(), quantity, table.header_line(), of_heading);
    if (!match && of_heading.empty())
        add_missing_column(table.columns(), quantity, table.header_line(), of_heading);
    numbers.faults().add(of_heading);
    if (!match)
        return {};
    std::vector<double> values = numbers.read(match->index, MissingValues::allowed);
    for (double& value : values)
        value *= match->si_factor;
    return values;
}

std::vector<fit::MeasuredPoint> points_of(const CsvTable& table,
                                          const std::optional<std::string>& deviation_column) {
    NumberColumns numbers(table);
    const std::vector<double> rates = column(table, numbers, ColumnQuantity::shear_rate);
    const std::vector<double> stresses = column(table, numbers, ColumnQuantity::shear_stress);
    std::vector<double> deviations;
    if (deviation_column) {
        const auto index = table.find(*deviation_column);
        if (index) {
            deviations = numbers.read(*index, MissingValues::allowed);
            TableFaults ignored(table.name());
            if (const auto match = find_column(table.columns(), ColumnQuantity::shear_stress,
                                               table.header_line(), ignored))
                for (double& value : deviations)
                    value *= match->si_factor;
        } else {
            numbers.faults().add({table.header_line(), *deviation_column,
                                  "there is no such column of standard deviations; --weights takes "
                                  "relative, fitted, absolute, log or a column's name"});
        }
    }
    numbers.throw_if_any();
    const auto regime = table.find("regime");
    std::vector<fit::MeasuredPoint> points;
    for (std::size_t row = 0; row < table.rows(); ++row)
        points.push_back(
            {.rate = rates[row],
             .stress = stresses[row],
             .deviation =
                 deviations.empty() ? std::numeric_limits<double>::quiet_NaN() : deviations[row],
             .line = table.line(row),
             .regime = regime ? std::string(table.text(row, *regime)) : std::string()});
    return points;
}

/// A stretch of a text that is a table with headings, and the last line of text before it.
struct Section {
    std::size_t first_line{}; ///< 0-based
    std::size_t end_line{};
    std::string name;
};

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

/// True for a line that names a shear rate and a shear stress in different fields.
bool is_heading(std::string_view line, char delimiter) {
    bool rate = false;
    bool stress = false;
    std::size_t fields = 0;
    while (true) {
        const std::size_t end = line.find(delimiter);
        std::string field;
        for (const char c : line.substr(0, end))
            field +=
                c == '_' || c == '"' ? ' ' : static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
        const std::string_view name = trimmed(field);
        ++fields;
        rate = rate || name.starts_with("shear rate");
        stress = stress || name.starts_with("shear stress") || name == "stress";
        if (end == std::string_view::npos)
            break;
        line.remove_prefix(end + 1);
    }
    return rate && stress && fields >= 2;
}

std::vector<std::string_view> fields_of(std::string_view line, char delimiter) {
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t end = line.find(delimiter);
        fields.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos)
            return fields;
        line.remove_prefix(end + 1);
    }
}

/// Headings with the units of the line below them, where that line is one of units in brackets
/// (which may hold units that no column of interest has); empty: it is none.
std::string headings_with_units(std::string_view headings, std::string_view units) {
    for (const char delimiter : {'\t', ';', ','}) {
        if (!is_heading(headings, delimiter))
            continue;
        const auto names = fields_of(headings, delimiter);
        const auto below = fields_of(units, delimiter);
        bool any = false;
        for (const std::string_view unit : below) {
            if (!unit.empty() && !(unit.starts_with('[') && unit.ends_with(']')))
                return "";
            any = any || !unit.empty();
        }
        if (!any || below.size() > names.size())
            return "";
        std::string merged;
        for (std::size_t i = 0; i < names.size(); ++i) {
            merged += i == 0 ? "" : std::string(1, delimiter);
            merged += names[i];
            if (i < below.size() && !below[i].empty())
                merged += " " + std::string(below[i]);
        }
        return merged;
    }
    return "";
}

std::vector<Section> sections_of(const std::vector<std::string_view>& lines) {
    std::vector<Section> sections;
    std::string name;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::string_view line = trimmed(lines[k]);
        bool heading = false;
        for (const char delimiter : {'\t', ';', ','})
            heading = heading || is_heading(lines[k], delimiter);
        if (heading) {
            Section section{k, k + 1, name};
            // Exports may put an empty line between headings, units and rows.
            bool in_rows = false;
            for (; section.end_line < lines.size(); ++section.end_line) {
                const std::string_view row = trimmed(lines[section.end_line]);
                if (row.empty() && in_rows)
                    break;
                in_rows = in_rows || row.find_first_of("0123456789") == 0 || row.starts_with('-');
            }
            k = section.end_line;
            sections.push_back(std::move(section));
        } else if (!line.empty() && !line.starts_with('#')) {
            // "Result:<TAB>Flow curve 1" and "[Flow sweep - 1]" name what follows; other lines of a
            // preamble rarely do.
            std::string_view words = line;
            if (words.starts_with("Result:") || words.starts_with("Test:"))
                words = trimmed(words.substr(words.find(':') + 1));
            else if (words.starts_with('[') && words.ends_with(']'))
                words = words.substr(1, words.size() - 2);
            else
                continue;
            name = std::string(words);
        }
    }
    return sections;
}

FlowCurveFile from_text(const fs::path& file, std::string_view bytes,
                        const std::optional<std::string>& deviation_column) {
    std::string text;
    try {
        text = decode_text(bytes);
    } catch (const std::invalid_argument& error) {
        throw TableError(file.string(), {{0, {}, error.what()}});
    }
    const std::vector<std::string_view> lines = lines_of(text);
    FlowCurveFile result;
    if (is_block_file(lines)) {
        for (CurveBlock& block : read_curve_blocks(lines, file.string()))
            result.curves.push_back({std::move(block.name), std::move(block.points)});
        return result;
    }
    const std::vector<Section> sections = sections_of(lines);
    const bool plain = sections.size() <= 1 &&
                       (sections.empty() || sections.front().first_line == 0) &&
                       (lines.size() < 2 || headings_with_units(lines[0], lines[1]).empty());
    if (plain) {
        const CsvTable table = CsvTable::parse(bytes, file.string());
        result.curves.push_back({file.stem().string(), points_of(table, deviation_column)});
        return result;
    }
    for (const Section& section : sections) {
        std::string table_text;
        std::size_t below = section.first_line + 1;
        while (below < section.end_line && trimmed(lines[below]).empty())
            ++below;
        const std::string merged =
            below < section.end_line ? headings_with_units(lines[section.first_line], lines[below])
                                     : std::string();
        for (std::size_t k = section.first_line; k < section.end_line; ++k) {
            const bool blank = trimmed(lines[k]).empty(); // delimiters alone are no row
            if (!blank && (merged.empty() || (k != section.first_line && k != below)))
                table_text += lines[k];
            else if (!merged.empty() && k == section.first_line)
                table_text += merged;
            table_text += '\n';
        }
        const CsvTable table = CsvTable::parse(table_text, file.string(), section.first_line + 1);
        std::string name =
            section.name.empty() && sections.size() == 1 ? file.stem().string()
            : section.name.empty()
                ? fmt::format("{} (line {})", file.stem().string(), section.first_line + 1)
                : section.name;
        result.curves.push_back({std::move(name), points_of(table, deviation_column)});
    }
    return result;
}

FlowCurveFile from_trios(const std::vector<Sheet>& sheets, const fs::path& file) {
    FlowCurveFile result;
    MeasuredData data = measured_from_trios(sheets, file.string());
    result.remarks = std::move(data.remarks);
    for (MeasuredStep& step : data.steps) {
        if (step.exported_rate.empty() || step.exported_stress.empty()) {
            result.remarks.push_back(
                fmt::format("step \"{}\" has no rate and stress; it is left out", step.name));
            continue;
        }
        FlowCurveTable curve{std::move(step.name), {}};
        for (std::size_t k = 0; k < step.exported_rate.size(); ++k)
            curve.points.push_back({.rate = step.exported_rate[k],
                                    .stress = step.exported_stress[k],
                                    .deviation = std::numeric_limits<double>::quiet_NaN(),
                                    .line = 0,
                                    .regime = {}});
        result.curves.push_back(std::move(curve));
    }
    if (result.curves.empty())
        throw TableError(file.string(),
                         {{0, {}, "no step of this export has a shear rate and a shear stress"}});
    return result;
}

} // namespace

FlowCurveFile read_flow_curves(const fs::path& file,
                               const std::optional<std::string>& deviation_column) {
    const std::vector<Sheet> sheets = sheets_of(file);
    if (sheets.empty())
        return from_text(file, bytes_of(file), deviation_column);
    if (is_trios_layout(sheets))
        return from_trios(sheets, file);
    FlowCurveFile result;
    for (const Sheet& sheet : sheets) {
        if (sheet.rows == 0)
            continue;
        // Messages and curves name the sheet.
        FlowCurveFile read = from_text(fmt::format("{}, sheet {}", file.string(), sheet.name),
                                       tab_delimited(sheet), deviation_column);
        for (FlowCurveTable& curve : read.curves)
            result.curves.push_back(std::move(curve));
    }
    if (result.curves.empty())
        throw TableError(file.string(), {{0, {}, "the workbook's sheets are empty"}});
    return result;
}

} // namespace searle::rheometry
