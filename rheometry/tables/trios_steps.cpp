#include "rheometry/tables/column_names.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "rheometry/tables/number_text.hpp"
#include "rheometry/tables/spreadsheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace searle::rheometry {
namespace {

// Of a step's sheet.
constexpr std::size_t title_row = 0;
constexpr std::size_t heading_row = 1;
constexpr std::size_t unit_row = 2;
constexpr std::size_t first_data_row = 3;

/// "28.0 mm" or a bare number.
std::optional<double> value_in_si(const SheetCell& cell, ColumnQuantity quantity) {
    const auto* const text = std::get_if<std::string>(&cell);
    if (text == nullptr)
        return std::nullopt;
    const std::size_t blank = text->find(' ');
    const NumberText number = read_number(text->substr(0, blank));
    if (blank == std::string::npos || number.outcome != NumberText::Outcome::number)
        return std::nullopt;
    const std::optional<double> factor = si_factor(quantity, text->substr(blank + 1));
    return factor ? std::optional(number.value * *factor) : std::nullopt;
}

std::optional<double> halved(std::optional<double> diameter) {
    return diameter ? std::optional(0.5 * *diameter) : std::nullopt;
}

ExportedGeometry geometry_of(const Sheet& details) {
    ExportedGeometry geometry;
    for (std::size_t row = 0; row < details.rows && details.columns >= 2; ++row) {
        const std::string_view key = details.text(row, 0);
        const SheetCell& cell = details.cell(row, 1);
        if (key == "Geometry name")
            geometry.name = std::string(details.text(row, 1));
        else if (key == "Bob diameter")
            geometry.bob_radius = halved(value_in_si(cell, ColumnQuantity::length));
        else if (key == "Cup diameter")
            geometry.cup_radius = halved(value_in_si(cell, ColumnQuantity::length));
        else if (key == "Bob length")
            geometry.bob_length = value_in_si(cell, ColumnQuantity::length);
        else if (key == "End effect factor" && std::holds_alternative<double>(cell))
            geometry.end_factor = std::get<double>(cell);
        else if (key == "Stress constant")
            geometry.stress_constant = value_in_si(cell, ColumnQuantity::stress_constant);
        else if (key == "Strain constant")
            geometry.strain_constant = value_in_si(cell, ColumnQuantity::strain_constant);
    }
    return geometry;
}

/// Reads the columns of one step.
class StepReader {
public:
    StepReader(const Sheet& sheet, TableFaults& faults) : sheet_(sheet), faults_(faults) {
        for (std::size_t column = 0; column < sheet.columns; ++column)
            headings_.push_back({.name = std::string(sheet.text(heading_row, column)),
                                 .unit = std::string(sheet.text(unit_row, column))});
    }

    /// The column with exactly this heading, in SI units, NaN for empty cells; empty when there is
    /// none.
    [[nodiscard]] std::vector<double> column(std::string_view heading, ColumnQuantity quantity) {
        const auto found = std::ranges::find(headings_, heading, &Heading::name);
        if (found == headings_.end())
            return {};
        const auto index = static_cast<std::size_t>(found - headings_.begin());
        const std::optional<double> factor = si_factor(quantity, found->unit);
        if (!factor) {
            add_fault(unit_row, heading,
                      fmt::format("\"{}\" is no unit of this quantity; allowed: {}", found->unit,
                                  usual_units(quantity)));
            return {};
        }
        std::vector<double> values;
        for (std::size_t row = first_data_row; row < sheet_.rows; ++row) {
            if (is_empty(row))
                continue;
            const SheetCell& cell = sheet_.cell(row, index);
            const auto* const number = std::get_if<double>(&cell);
            if (std::holds_alternative<std::string>(cell) ||
                (number != nullptr && !std::isfinite(*number)))
                add_fault(row, heading,
                          fmt::format("\"{}\" is not a number", sheet_.text(row, index)));
            values.push_back(number == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                               : *number * *factor);
        }
        return values;
    }

private:
    [[nodiscard]] bool is_empty(std::size_t row) const {
        for (std::size_t column = 0; column < sheet_.columns; ++column)
            if (!std::holds_alternative<std::monostate>(sheet_.cell(row, column)))
                return false;
        return true;
    }
    void add_fault(std::size_t row, std::string_view heading, const std::string& message) {
        faults_.add(
            {row + 1, std::string(heading), fmt::format("sheet \"{}\": {}", sheet_.name, message)});
    }

    const Sheet& sheet_;
    TableFaults& faults_;
    std::vector<Heading> headings_;
};

/// Mean speed between the neighbours of each row.
std::vector<double> speed_from(const std::vector<double>& angle, const std::vector<double>& time) {
    std::vector<double> speed(angle.size());
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0;
        const std::size_t after = std::min(i + 1, speed.size() - 1);
        speed[i] = (angle[after] - angle[before]) / (time[after] - time[before]);
    }
    return speed;
}

bool increases(const std::vector<double>& values) {
    return values.size() >= 2 &&
           std::ranges::adjacent_find(values, std::greater_equal{}) == values.end();
}

/// Leaves out the rows in which one of the columns that the step has is empty.
void drop_incomplete(MeasuredStep& step, std::vector<double>& angle, MeasuredData& data) {
    const std::array<std::vector<double>*, 6> columns{
        &step.time, &step.speed, &step.torque, &step.exported_rate, &step.exported_stress, &angle};
    const std::size_t rows = step.torque.size();
    std::vector<bool> whole(rows, true);
    for (const std::vector<double>* column : columns)
        for (std::size_t row = 0; row < column->size(); ++row)
            whole[row] = whole[row] && std::isfinite((*column)[row]);
    const auto left = static_cast<std::size_t>(std::ranges::count(whole, false));
    if (left == 0)
        return;
    for (std::vector<double>* column : columns) {
        std::size_t kept = 0;
        for (std::size_t row = 0; row < column->size(); ++row)
            if (whole[row])
                (*column)[kept++] = (*column)[row];
        column->resize(kept);
    }
    data.remarks.push_back(
        fmt::format("step \"{}\": {} of {} rows left out: a cell is empty", step.name, left, rows));
}

std::optional<MeasuredStep> read_step(const Sheet& sheet, MeasuredData& data, TableFaults& faults) {
    StepReader reader(sheet, faults);
    MeasuredStep step;
    step.name = sheet.name;
    step.torque = reader.column("Torque", ColumnQuantity::torque);
    step.time = reader.column("Step time", ColumnQuantity::time);
    if (step.time.empty())
        step.time = reader.column("Time", ColumnQuantity::time);
    step.speed = reader.column("Velocity", ColumnQuantity::angular_velocity);
    step.exported_rate = reader.column("Shear rate", ColumnQuantity::shear_rate);
    step.exported_stress = reader.column("Stress", ColumnQuantity::shear_stress);
    std::vector<double> angle;
    if (step.speed.empty() && (step.exported_rate.empty() || !data.geometry.strain_constant))
        angle = reader.column("Displacement", ColumnQuantity::angle);
    if (!step.torque.empty() && faults.empty())
        drop_incomplete(step, angle, data);
    if (step.torque.empty()) {
        data.remarks.push_back(fmt::format("step \"{}\" left out: it has no torque column, as in "
                                           "oscillation",
                                           sheet.name));
        return std::nullopt;
    }
    if (!step.speed.empty())
        return step;
    if (!step.exported_rate.empty() && data.geometry.strain_constant) {
        for (const double rate : step.exported_rate)
            step.speed.push_back(rate / *data.geometry.strain_constant);
        data.remarks.push_back(fmt::format(
            "step \"{}\" has no velocity: speed = its shear rate / the strain constant {} 1/rad",
            sheet.name, *data.geometry.strain_constant));
        return step;
    }
    if (!angle.empty() && increases(step.time)) {
        step.speed = speed_from(angle, step.time);
        step.is_flow_curve = false;
        data.remarks.push_back(
            fmt::format("step \"{}\" has no velocity: speed = differences of its displacement over "
                        "its time, as coarse as these are written",
                        sheet.name));
        return step;
    }
    data.remarks.push_back(fmt::format(
        "step \"{}\" left out: it has no velocity, and nothing to derive it from", sheet.name));
    return std::nullopt;
}

} // namespace

bool is_trios_layout(std::span<const Sheet> sheets) {
    return std::ranges::any_of(sheets, [](const Sheet& sheet) { return sheet.name == "Details"; });
}

MeasuredData measured_from_trios(std::span<const Sheet> sheets, const std::string& file) {
    MeasuredData data;
    TableFaults faults(file);
    for (const Sheet& sheet : sheets)
        if (sheet.name == "Details")
            data.geometry = geometry_of(sheet);
    for (const Sheet& sheet : sheets) {
        if (sheet.name == "Details")
            continue;
        if (sheet.rows <= first_data_row || sheet.text(title_row, 0).empty()) {
            data.remarks.push_back(
                fmt::format("sheet \"{}\" left out: it is not laid out as a step", sheet.name));
            continue;
        }
        if (std::optional<MeasuredStep> step = read_step(sheet, data, faults))
            data.steps.push_back(std::move(*step));
    }
    if (data.steps.empty() && faults.empty()) {
        std::string message = "no step with a torque and a speed: is this an export of TRIOS?";
        for (const std::string& remark : data.remarks)
            message += fmt::format("\n  {}", remark);
        faults.add({0, {}, std::move(message)});
    }
    faults.throw_if_any();
    return data;
}

} // namespace searle::rheometry
