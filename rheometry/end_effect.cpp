#include "rheometry/end_effect.hpp"

#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_columns.hpp"
#include "rheometry/tables/number_text.hpp"

#include <array>
#include <string_view>

namespace searle::rheometry {
namespace {

struct Column {
    std::string_view name;
    double EndEffect::*value;
};
constexpr std::array columns{
    Column{"angular_velocity_rad_s", &EndEffect::speed},
    Column{"shear_rate_1_s", &EndEffect::shear_rate},
    Column{"end_factor", &EndEffect::end_factor},
    Column{"end_factor_error", &EndEffect::error},
    Column{"end_factor_lower_bound", &EndEffect::lower},
    Column{"end_factor_upper_bound", &EndEffect::upper},
    Column{"end_factor_with_inertia", &EndEffect::with_inertia},
    Column{"end_factor_with_inertia_error", &EndEffect::with_inertia_error}};

} // namespace

std::string end_effect_csv(const std::vector<EndEffect>& rows) {
    std::string text;
    for (const Column& column : columns) {
        text += (text.empty() ? "" : ",") + std::string{column.name};
    }
    text += '\n';
    for (const EndEffect& row : rows) {
        std::string line;
        for (const Column& column : columns) {
            line += (line.empty() ? "" : ",") + number_text(row.*column.value);
        }
        text += line + '\n';
    }
    return text;
}

std::vector<EndEffect> read_end_effect_csv(const std::filesystem::path& file) {
    const CsvTable table = CsvTable::read(file);
    NumberColumns numbers(table);
    std::vector<EndEffect> rows(table.rows());
    for (const Column& column : columns) {
        const auto index = table.find(column.name);
        if (!index) {
            numbers.faults().add({table.header_line(), std::string{column.name},
                                  "the column is missing; this is no table of end factors"});
            continue;
        }
        const std::vector<double> values = numbers.read(*index, MissingValues::allowed);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            rows[row].*column.value = values[row];
        }
    }
    numbers.faults().throw_if_any();
    return rows;
}

} // namespace searle::rheometry
