#include "rheometry/tables/measured_data.hpp"

#include "rheometry/tables/column_names.hpp"
#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_columns.hpp"
#include "rheometry/tables/number_text.hpp"

namespace searle::rheometry {
namespace {

std::vector<double> column_in_si(NumberColumns& numbers, const ColumnMatch& match) {
    std::vector<double> values = numbers.read(match.index, MissingValues::forbidden);
    if (match.si_factor != 1.0)
        for (double& value : values)
            value *= match.si_factor;
    return values;
}

} // namespace

MeasuredData measured_from_table(const CsvTable& table, DriveMotion motion) {
    const bool turns = motion == DriveMotion::turning;
    NumberColumns numbers(table);
    const auto column = [&](ColumnQuantity quantity, bool required) -> std::vector<double> {
        // A fault of the heading itself is told by find_column; only a silent absence is added.
        TableFaults of_heading(table.name());
        const auto match = find_column(table.columns(), quantity, table.header_line(), of_heading);
        numbers.faults().add(of_heading);
        if (match)
            return column_in_si(numbers, *match);
        if (required && of_heading.empty())
            add_missing_column(table.columns(), quantity, table.header_line(), numbers.faults());
        return {};
    };
    MeasuredStep step;
    step.time = column(ColumnQuantity::time, false);
    step.speed =
        column(turns ? ColumnQuantity::angular_velocity : ColumnQuantity::wall_speed, true);
    step.torque = column(turns ? ColumnQuantity::torque : ColumnQuantity::wall_force, true);
    numbers.throw_if_any();
    const auto regime = table.find("regime");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        step.lines.push_back(table.line(row));
        if (regime)
            step.regimes.emplace_back(trimmed(table.text(row, *regime)));
    }
    MeasuredData data;
    data.steps.push_back(std::move(step));
    return data;
}

} // namespace searle::rheometry
