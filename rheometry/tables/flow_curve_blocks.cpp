#include "rheometry/tables/flow_curve_blocks.hpp"

#include "rheometry/tables/number_text.hpp"
#include "rheometry/tables/table_error.hpp"

#include <fmt/format.h>

#include <limits>

namespace searle::rheometry {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t end = line.find('\t');
        fields.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos)
            break;
        line.remove_prefix(end + 1);
    }
    while (!fields.empty() && fields.back().empty())
        fields.pop_back();
    return fields;
}

bool is_number(std::string_view field) {
    return read_number(field).outcome == NumberText::Outcome::number;
}

bool is_block_start(std::span<const std::string_view> fields) {
    return fields.size() >= 2 && fields.size() <= 3 && is_number(fields[0]) &&
           !is_number(fields[1]) && !fields[1].empty();
}

double value_of(std::string_view field, std::size_t line, const char* column, TableFaults& faults) {
    const NumberText number = read_number(field);
    switch (number.outcome) {
    case NumberText::Outcome::number:
        return number.value;
    case NumberText::Outcome::empty:
    case NumberText::Outcome::not_finite:
        break;
    case NumberText::Outcome::not_a_number:
    case NumberText::Outcome::out_of_range:
        faults.add({line, column, fmt::format("\"{}\" is not a number", field)});
    }
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

bool is_block_file(std::span<const std::string_view> lines) {
    std::size_t k = 0;
    while (k < lines.size() && trimmed(lines[k]).empty())
        ++k;
    if (k + 1 >= lines.size() || !is_block_start(fields_of(lines[k])))
        return false;
    const std::vector<std::string_view> row = fields_of(lines[k + 1]);
    return row.size() == 2 && is_number(row[0]) && is_number(row[1]);
}

std::vector<CurveBlock> read_curve_blocks(std::span<const std::string_view> lines,
                                          const std::string& file) {
    TableFaults faults(file);
    std::vector<CurveBlock> blocks;
    bool inside = false;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::vector<std::string_view> fields = fields_of(lines[k]);
        if (fields.empty()) {
            inside = false;
        } else if (!inside && is_block_start(fields)) {
            blocks.push_back({fmt::format("{} {}", fields[0], fields[1]), {}});
            inside = true;
        } else if (!inside || fields.size() != 2) {
            faults.add({k + 1,
                        {},
                        inside ? fmt::format("{} fields; a row is a shear rate in 1/s, a tab and a "
                                             "shear stress in Pa",
                                             fields.size())
                               : std::string("a row outside of a block; a block starts with a "
                                             "number, a tab and a name")});
        } else {
            blocks.back().points.push_back(
                {.rate = value_of(fields[0], k + 1, "shear rate", faults),
                 .stress = value_of(fields[1], k + 1, "shear stress", faults),
                 .deviation = std::numeric_limits<double>::quiet_NaN(),
                 .line = k + 1,
                 .regime = {}});
        }
    }
    faults.throw_if_any();
    return blocks;
}

} // namespace searle::rheometry
