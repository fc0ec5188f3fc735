#include "rheometry/rheogram_csv.hpp"

#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_columns.hpp"
#include "rheometry/tables/number_text.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string_view>

namespace searle::rheometry {
namespace {

struct NumberColumn {
    std::string_view name;
    double RheogramPoint::*value;
};

constexpr NumberColumn time_column{"time_s", &RheogramPoint::time};
constexpr std::array turning_drive{NumberColumn{"angular_velocity_rad_s", &RheogramPoint::speed},
                                   NumberColumn{"torque_N_m", &RheogramPoint::torque}};
constexpr std::array sliding_drive{NumberColumn{"wall_speed_m_s", &RheogramPoint::speed},
                                   NumberColumn{"wall_force_N", &RheogramPoint::torque}};
constexpr NumberColumn rate_column{"shear_rate_1_s", &RheogramPoint::shear_rate};
constexpr NumberColumn stress_column{"shear_stress_Pa", &RheogramPoint::shear_stress};
constexpr std::array before_regime{rate_column, stress_column,
                                   NumberColumn{"viscosity_Pa_s", &RheogramPoint::viscosity},
                                   NumberColumn{"stress_error_Pa", &RheogramPoint::stress_error}};
constexpr std::string_view regime_column = "regime";
constexpr std::array after_regime{
    NumberColumn{"steady_stress_Pa", &RheogramPoint::steady_stress},
    NumberColumn{"bob_shear_rate_1_s", &RheogramPoint::bob_shear_rate},
    NumberColumn{"yield_radius_m", &RheogramPoint::yield_radius}};

struct SuspensionColumn {
    std::string_view name;
    double SuspensionStress::*value;
};

constexpr std::array suspension_columns{
    SuspensionColumn{"fluid_stress_Pa", &SuspensionStress::fluid},
    SuspensionColumn{"hydrodynamic_stress_Pa", &SuspensionStress::hydrodynamic},
    SuspensionColumn{"contact_stress_Pa", &SuspensionStress::contact},
    SuspensionColumn{"dlvo_stress_Pa", &SuspensionStress::dlvo},
    SuspensionColumn{"brownian_stress_Pa", &SuspensionStress::brownian},
    SuspensionColumn{"statistical_error_Pa", &SuspensionStress::statistical_error},
    SuspensionColumn{"bulk_fluid_stress_Pa", &SuspensionStress::bulk_fluid},
    SuspensionColumn{"bulk_hydrodynamic_stress_Pa", &SuspensionStress::bulk_hydrodynamic},
    SuspensionColumn{"bulk_contact_stress_Pa", &SuspensionStress::bulk_contact},
    SuspensionColumn{"bulk_dlvo_stress_Pa", &SuspensionStress::bulk_dlvo},
    SuspensionColumn{"bulk_brownian_stress_Pa", &SuspensionStress::bulk_brownian},
    SuspensionColumn{"first_normal_stress_difference_Pa",
                     &SuspensionStress::first_normal_difference},
    SuspensionColumn{"second_normal_stress_difference_Pa",
                     &SuspensionStress::second_normal_difference},
    SuspensionColumn{"particle_pressure_Pa", &SuspensionStress::particle_pressure},
    SuspensionColumn{"contact_number", &SuspensionStress::contact_number},
    SuspensionColumn{"independent_values", &SuspensionStress::independent_values}};

bool is_suspension(const Rheogram& rheogram) {
    return !rheogram.points.empty() && rheogram.points.front().suspension.has_value();
}

constexpr const std::array<NumberColumn, 2>& drive_of(DriveColumns columns) {
    return columns == DriveColumns::turning ? turning_drive : sliding_drive;
}

/// Calls `visit` with every column that holds numbers, in the file's order; `at_regime` in between.
template <class Visit, class AtRegime>
void for_each_column(DriveColumns columns, Visit visit, AtRegime at_regime) {
    visit(time_column);
    for (const NumberColumn& column : drive_of(columns))
        visit(column);
    for (const NumberColumn& column : before_regime)
        visit(column);
    at_regime();
    for (const NumberColumn& column : after_regime)
        visit(column);
}

DriveColumns drive_in(const CsvTable& table) {
    const auto any_of = [&table](const std::array<NumberColumn, 2>& drive) {
        return table.find(drive[0].name) || table.find(drive[1].name);
    };
    const bool slides = any_of(sliding_drive);
    if (slides && any_of(turning_drive)) {
        TableFaults faults(table.name());
        faults.add({table.header_line(),
                    {},
                    "columns of a turning drive (angular_velocity_rad_s, torque_N_m) and of a "
                    "sliding one (wall_speed_m_s, wall_force_N); one kind is allowed"});
        faults.throw_if_any();
    }
    return slides ? DriveColumns::sliding : DriveColumns::turning;
}

} // namespace

DriveColumns drive_columns(const geometry::Instrument& instrument) {
    return geometry::rotates(instrument) ? DriveColumns::turning : DriveColumns::sliding;
}

std::string rheogram_header(DriveColumns columns, bool suspension) {
    std::string header;
    const auto append = [&header](std::string_view name) {
        if (!header.empty())
            header += ',';
        header += name;
    };
    for_each_column(
        columns, [&](const NumberColumn& column) { append(column.name); },
        [&] { append(regime_column); });
    for (const SuspensionColumn& column : suspension_columns)
        if (suspension)
            append(column.name);
    return header;
}

void write_rheogram_csv(std::ostream& stream, const Rheogram& rheogram, DriveColumns columns) {
    const bool suspension = is_suspension(rheogram);
    stream << rheogram_header(columns, suspension) << '\n';
    std::string line;
    for (const RheogramPoint& point : rheogram.points) {
        line.clear();
        for_each_column(
            columns,
            [&](const NumberColumn& column) {
                line += number_text(point.*column.value);
                line += ',';
            },
            [&] {
                line += point.regime;
                line += ',';
            });
        for (const SuspensionColumn& column : suspension_columns)
            if (suspension) {
                line += number_text(point.suspension.value_or(SuspensionStress{}).*column.value);
                line += ',';
            }
        line.back() = '\n';
        stream << line;
    }
}

RheogramFile read_rheogram_csv(const std::filesystem::path& file) {
    const CsvTable table = CsvTable::read(file);
    NumberColumns numbers(table);
    RheogramFile result;
    result.columns = drive_in(table);
    std::vector<RheogramPoint>& points = result.rheogram.points;
    points.resize(table.rows());
    for_each_column(
        result.columns,
        [&](const NumberColumn& column) {
            const bool required =
                column.name == rate_column.name || column.name == stress_column.name;
            const std::optional<std::size_t> index = table.find(column.name);
            std::vector<double> values(points.size(), std::numeric_limits<double>::quiet_NaN());
            if (index)
                values = numbers.read(*index,
                                      required ? MissingValues::forbidden : MissingValues::allowed);
            else if (required)
                numbers.faults().add({table.header_line(), std::string(column.name),
                                      "the column is missing; a rheogram needs shear_rate_1_s and "
                                      "shear_stress_Pa"});
            for (std::size_t row = 0; row < points.size(); ++row)
                points[row].*column.value = values[row];
        },
        [&] {
            if (const std::optional<std::size_t> index = table.find(regime_column))
                for (std::size_t row = 0; row < points.size(); ++row)
                    points[row].regime = std::string(trimmed(table.text(row, *index)));
        });
    if (table.find(suspension_columns.front().name))
        for (const SuspensionColumn& column : suspension_columns)
            if (const std::optional<std::size_t> index = table.find(column.name)) {
                const std::vector<double> values = numbers.read(*index, MissingValues::allowed);
                for (std::size_t row = 0; row < points.size(); ++row) {
                    if (!points[row].suspension)
                        points[row].suspension.emplace();
                    (*points[row].suspension).*column.value = values[row];
                }
            }
    numbers.throw_if_any();
    if (!table.find("viscosity_Pa_s"))
        for (RheogramPoint& point : points)
            if (point.shear_rate != 0.0)
                point.viscosity = point.shear_stress / point.shear_rate;
    return result;
}

} // namespace searle::rheometry
