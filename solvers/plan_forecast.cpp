#include "solvers/plan_forecast.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/plan_lag.hpp"
#include "solvers/plan_steady_curve.hpp"
#include "solvers/plan_vortices.hpp"
#include "solvers/regime.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::solvers {
namespace {

using Schedule = std::variant<rheometry::SteadySpeeds, rheometry::SpeedHistory>;

std::vector<double> row_speeds(const Schedule& schedule) {
    if (const auto* series = std::get_if<rheometry::SteadySpeeds>(&schedule)) {
        return series->speeds;
    }
    const auto& history = std::get<rheometry::SpeedHistory>(schedule);
    std::vector<double> speeds;
    speeds.reserve(history.row_times.size());
    for (const double time : history.row_times) {
        speeds.push_back(history.speed_at(time));
    }
    return speeds;
}

/// Every speed that a steady flow will be asked for: of the rows, and where the history bends.
std::vector<double> visited_speeds(const Schedule& schedule, const std::vector<double>& rows) {
    std::vector<double> speeds = rows;
    if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule)) {
        speeds.push_back(history->initial_speed);
        for (const rheometry::SpeedHistory::Piece& piece : history->pieces) {
            speeds.push_back(piece.start_speed);
            speeds.push_back(piece.end_speed);
        }
    }
    return speeds;
}

} // namespace

double end_flow_share(double radius_ratio, double length_ratio, double reynolds) {
    // M / M_creeping - 1 of the ISO bob: Re^2 at first, Re^0.8 where boundary layers form.
    constexpr double slow = 9.7e-7;
    constexpr double turning_point = 185.0;
    constexpr double exponent = 0.6;
    const double iso = slow * reynolds * reynolds /
                       std::pow(1.0 + std::pow(reynolds / turning_point, 2), exponent);
    // The torque of the cylinder over that of the ISO one, both over R^3.
    constexpr double iso_ratio = 1.0847;
    constexpr double iso_length = 3.0;
    const auto narrowness = [](double ratio) { return 1.0 - 1.0 / (ratio * ratio); };
    const double cylinder =
        length_ratio / iso_length * narrowness(iso_ratio) / narrowness(radius_ratio);
    const double extra = iso / cylinder;
    return extra / (1.0 + extra);
}

Forecast forecast(const Scene& scene) {
    Forecast result;
    result.conversion = rheometry::conversion_for(scene.instrument, scene.conversion);
    const Schedule schedule = rheometry::schedule(scene.protocol, result.conversion);
    const std::vector<double> speeds = row_speeds(schedule);
    SteadyCurve curve(scene.instrument, scene.fluid, visited_speeds(schedule, speeds));
    result.steady_series = std::holds_alternative<rheometry::SteadySpeeds>(schedule);

    std::vector<double> times;
    std::vector<LagForecast> lags(speeds.size());
    if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule)) {
        times = history->row_times;
        lags = forecast_lag(*history, curve);
    } else {
        times = settling_times(curve, 0.0, speeds, scene.solver.accuracy);
    }

    const bool has_ends = geometry::has_ends(scene.instrument);
    const double end_factor = has_ends ? result.conversion.end_factor : 1.0;
    const InstrumentGap& decisive = curve.gaps().back();
    const bool is_plane = decisive.plane_width > 0.0;
    std::optional<VortexForecast> vortices;
    if (!is_plane) {
        vortices.emplace(decisive, scene.fluid);
    }

    result.rows.resize(speeds.size());
    result.facts.resize(speeds.size());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        RowForecast& row = result.rows[i];
        RowFacts& facts = result.facts[i];
        row.time = times[i];
        row.speed = speeds[i];
        row.shear_rate = result.conversion.shear_rate(row.speed);
        row.lag_share = lags[i].share;
        row.largest_lag_share = lags[i].largest;
        if (row.speed != 0.0) {
            const SteadyState& state = curve.at(row.speed);
            row.steady_stress =
                std::copysign(result.conversion.shear_stress(state.torque * end_factor), row.speed);
            for (std::size_t g = 0; g < curve.gaps().size(); ++g) {
                const Layer layer(curve.gaps()[g], scene.fluid, state.gaps[g]);
                facts.partly_sheared = facts.partly_sheared || layer.partly_sheared();
                if (g + 1 < curve.gaps().size()) {
                    continue;
                }
                facts.rotor_wall_rate = state.gaps[g].inner_rate;
                if (is_plane) {
                    facts.reynolds = std::abs(row.speed) * decisive.plane_width /
                                     layer.kinematic_viscosity(false);
                } else {
                    facts.yield_radius = layer.outer_radius();
                    vortices->add(i, row, facts, layer);
                }
            }
            if (has_ends) {
                const double radius = decisive.annulus.inner_radius;
                const double height =
                    decisive.torque_per_stress / (2.0 * std::numbers::pi * radius * radius);
                facts.end_flow_share = end_flow_share(decisive.annulus.outer_radius / radius,
                                                      height / radius, facts.end_reynolds);
                row.end_flow_share = facts.end_flow_share;
                row.end_reynolds = facts.end_reynolds;
            }
            facts.definition_error =
                std::abs(row.steady_stress) /
                    laws::flow::stress(scene.fluid.law, std::abs(row.shear_rate)) -
                1.0;
        }
    }
    if (vortices) {
        result.taylor = vortices->judge(scene.instrument, result.rows, result.facts);
        if (result.taylor->critical_speed) {
            result.taylor->onset_shear_rate =
                std::abs(result.conversion.shear_rate(*result.taylor->critical_speed));
        }
    }
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        RowForecast& row = result.rows[i];
        row.regime = regime_name({.speed = row.speed,
                                  .partly_sheared = result.facts[i].partly_sheared,
                                  .taylor_ratio = row.taylor_ratio,
                                  .lag_share = row.lag_share,
                                  .end_flow_share = result.facts[i].end_flow_share,
                                  .accuracy = scene.solver.accuracy});
    }
    return result;
}

} // namespace searle::solvers
