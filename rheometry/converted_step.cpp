#include "rheometry/converted_step.hpp"

#include "rheometry/disturbed_regime.hpp"
#include "rheometry/rheogram_csv.hpp"
#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace searle::rheometry {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

TorqueHistory history_of(const MeasuredStep& step) {
    TorqueHistory history;
    for (std::size_t row = 0; row < step.torque.size(); ++row)
        history.rows.push_back({.time = step.time.empty() ? not_known : step.time[row],
                                .speed = step.speed[row],
                                .torque = step.torque[row],
                                .torque_error = not_known,
                                .steady_torque = not_known,
                                .yield_radius = not_known});
    return history;
}

/// Largest difference over the size of the export's own value.
double largest_difference(const Rheogram& rheogram, double RheogramPoint::*value,
                          const std::vector<double>& exported) {
    double largest = exported.empty() ? not_known : 0.0;
    for (std::size_t row = 0; row < exported.size(); ++row)
        if (exported[row] != 0.0)
            largest =
                std::max(largest, std::abs(rheogram.points[row].*value / exported[row] - 1.0));
    return largest;
}

/// As RFC 4180 asks: quoted when it holds what would end a field.
std::string field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char character : text) {
        quoted += character;
        if (character == '"')
            quoted += '"';
    }
    return quoted + '"';
}

void forbid_overflow(const Rheogram& rheogram, const MeasuredStep& step) {
    for (std::size_t row = 0; row < rheogram.points.size(); ++row) {
        const RheogramPoint& point = rheogram.points[row];
        // A viscosity has no value at rest.
        if (std::isfinite(point.shear_rate) && std::isfinite(point.shear_stress) &&
            !std::isinf(point.viscosity))
            continue;
        throw std::overflow_error(fmt::format(
            "{} {}: speed {:g} and torque {:g} (SI) give a stress, a rate or a viscosity beyond "
            "the range of double precision; are the columns' units right?",
            step.lines.empty() ? "row" : "line", step.lines.empty() ? row + 1 : step.lines[row],
            step.speed[row], step.torque[row]));
    }
}

/// Rates from the rows whose torque is that of the steady flow of the law alone.
RotorRates rates_of_undisturbed(const MeasuredStep& step, const geometry::Instrument& instrument,
                                const Conversion& conversion) {
    std::vector<double> speeds;
    std::vector<std::size_t> rows;
    std::vector<double> torques;
    for (std::size_t row = 0; row < step.torque.size(); ++row) {
        if (!step.regimes.empty() && !disturbance_in(step.regimes[row]).empty())
            continue;
        rows.push_back(row);
        speeds.push_back(step.speed[row]);
        torques.push_back(step.torque[row]);
    }
    RotorRates all = rotor_rates(instrument, conversion.end_factor, step.speed, step.torque);
    if (rows.size() == step.torque.size())
        return all;
    const WallRates some = rotor_rates(instrument, conversion.end_factor, speeds, torques).rates;
    all.rates = no_rates(step.torque.size());
    all.rates.yield_stress = some.yield_stress;
    all.rates.yield_standard_error = some.yield_standard_error;
    for (std::size_t k = 0; k < rows.size(); ++k)
        all.rates.rows[rows[k]] = some.rows[k];
    return all;
}

} // namespace

ConvertedStep convert_step(const MeasuredStep& step, const geometry::Instrument& instrument,
                           const Conversion& conversion) {
    const std::vector<std::string> no_regime(step.torque.size());
    ConvertedStep converted;
    converted.name = step.name;
    converted.has_time = !step.time.empty();
    converted.rheogram = make_rheogram(history_of(step), conversion, no_regime);
    forbid_overflow(converted.rheogram, step);
    converted.at_rotor = rates_of_undisturbed(step, instrument, conversion);
    if (!step.is_flow_curve)
        converted.at_rotor.rates = no_rates(step.speed.size());
    for (const std::string& regime : step.regimes)
        converted.disturbed_rows += disturbance_in(regime).empty() ? 0 : 1;
    converted.stress_difference =
        largest_difference(converted.rheogram, &RheogramPoint::shear_stress, step.exported_stress);
    converted.rate_difference =
        largest_difference(converted.rheogram, &RheogramPoint::shear_rate, step.exported_rate);
    return converted;
}

std::string converted_csv(std::span<const ConvertedStep> steps,
                          const geometry::Instrument& instrument, const Conversion& conversion) {
    const bool with_time = std::ranges::any_of(steps, &ConvertedStep::has_time);
    const bool with_step =
        std::ranges::any_of(steps, [](const ConvertedStep& step) { return !step.name.empty(); });
    const bool turns = drive_columns(instrument) == DriveColumns::turning;

    std::string text = with_time ? "time_s," : "";
    text += turns ? "angular_velocity_rad_s,torque_N_m," : "wall_speed_m_s,wall_force_N,";
    text += "shear_rate_1_s,shear_stress_Pa,viscosity_Pa_s,bob_stress_Pa,bob_rate_true_1_s,"
            "bob_rate_standard_error_1_s,branch,";
    text += with_step ? "step,definition,end_factor\n" : "definition,end_factor\n";

    const auto put = [&text](double value) {
        text += number_text(value);
        text += ',';
    };
    const std::string ending = std::string(name_of(conversion.definition)) + ',' +
                               number_text(conversion.end_factor) + '\n';
    for (const ConvertedStep& step : steps) {
        for (std::size_t row = 0; row < step.rheogram.points.size(); ++row) {
            const RheogramPoint& point = step.rheogram.points[row];
            const WallRate& rate = step.at_rotor.rates.rows[row];
            if (with_time)
                put(point.time);
            put(point.speed);
            put(point.torque);
            put(point.shear_rate);
            put(point.shear_stress);
            put(point.viscosity);
            put(step.at_rotor.stresses[row]);
            put(rate.rate);
            put(rate.standard_error);
            text += name_of(rate.branch);
            text += ',';
            if (with_step)
                text += field(step.name) + ',';
            text += ending;
        }
    }
    return text;
}

} // namespace searle::rheometry
