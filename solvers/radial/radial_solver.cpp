#include "solvers/radial/radial_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/plan.hpp"
#include "solvers/radial/gap_fields.hpp"
#include "solvers/radial/rotor_gaps.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace searle::solvers::radial {
namespace {

constexpr std::size_t rows_between_reports = 256;

/// The factor by which the ends of the instrument raise the endless cylinder's torque.
double end_factor(const geometry::Instrument& instrument, const rheometry::Conversion& conversion) {
    return geometry::has_ends(instrument) ? conversion.end_factor : 1.0;
}

rheometry::TorqueRow steady_row(const Scene& scene, double factor, double time, double speed) {
    const SteadyInstrumentFlow flow =
        steady_instrument_flow(scene.instrument, scene.fluid.law, speed);
    const double torque = factor * flow.torque;
    return {.time = time,
            .speed = speed,
            .torque = torque,
            .torque_error = std::abs(torque) * flow.relative_error,
            .steady_torque = torque,
            .yield_radius = flow.yield_radius,
            .rotor_wall_rate = flow.rotor_wall_rate};
}

double yield_torque_of(const Scene& scene) {
    return yield_torque(rotor_gaps(scene.instrument, scene.fluid.density), scene.fluid.law);
}

/// Rows without inertia, at given times and speeds.
template <class SpeedAt>
RadialReport without_inertia(const Scene& scene, const Plan& plan, double factor, std::size_t rows,
                             bool inertia_skipped, const SpeedAt& speed_at,
                             const ProgressSink& progress) {
    RadialReport report;
    report.history.rows.reserve(rows);
    const double yield = factor * yield_torque_of(scene);
    double last_sign = 0.0;
    double last_torque = 0.0;
    try {
        for (std::size_t k = 0; k < rows; ++k) {
            rheometry::TorqueRow row = steady_row(scene, factor, plan.rows[k].time, speed_at(k));
            row.rests = row.speed == 0.0 && yield > 0.0;
            if (row.rests) {
                row.torque = last_sign * yield;
                row.torque_error = error_at_rest(row.torque, yield);
            } else if (inertia_skipped) {
                row.torque_error += left_out_margin * plan.rows[k].lag_share *
                                    std::max(std::abs(row.torque), std::abs(last_torque));
            }
            const double scale = std::max(std::abs(row.torque), 1e-3 * std::abs(last_torque));
            if (!row.rests && scale > 0.0) {
                report.worst_relative_error =
                    std::max(report.worst_relative_error, row.torque_error / scale);
            }
            if (row.speed != 0.0) {
                last_sign = std::copysign(1.0, row.speed);
                last_torque = row.torque;
            }
            report.history.rows.push_back(row);
            if (progress && k % rows_between_reports == 0) {
                progress(static_cast<double>(k) / static_cast<double>(rows), "steady flow");
            }
        }
    } catch (const Interrupted&) {
        report.interrupted = true;
    }
    report.reached = report.worst_relative_error <= scene.solver.accuracy;
    note_rest(report);
    return report;
}

RadialReport with_inertia(const Scene& scene, double factor, const rheometry::SpeedHistory& history,
                          const ProgressSink& progress) {
    const std::vector<RotorGap> gaps = rotor_gaps(scene.instrument, scene.fluid.density);
    const TransientTorque solved =
        solve_levels(gaps, scene.fluid.law, history, scene.solver.accuracy, progress);
    RadialReport report;
    report.transient = true;
    report.reached = solved.reached;
    report.interrupted = solved.interrupted;
    report.worst_relative_error = solved.worst_relative_error;
    report.worst_torque_imbalance = solved.momentum_defect;
    report.refinements = solved.levels;
    report.elements = solved.elements;
    report.time_steps = solved.steps;
    report.linear_solves = solved.linear_solves;
    report.unknowns = static_cast<long>(gaps.size()) * (4L * solved.elements + 1);
    report.history.rows.reserve(solved.torque.size());
    for (std::size_t k = 0; k < solved.torque.size(); ++k) {
        const double time = history.row_times[k];
        rheometry::TorqueRow row = steady_row(scene, factor, time, history.speed_at(time));
        row.torque = factor * solved.torque[k];
        row.torque_error = factor * solved.error[k];
        row.rests = k < solved.rests.size() && solved.rests[k];
        report.history.rows.push_back(row);
    }
    note_rest(report);
    return report;
}

RadialReport rows_of(const Scene& scene, const Plan& plan, const ProgressSink& progress) {
    const rheometry::Conversion conversion =
        rheometry::conversion_for(scene.instrument, scene.conversion);
    const double factor = end_factor(scene.instrument, conversion);
    const auto schedule = rheometry::schedule(scene.protocol, conversion);
    if (const auto* steady = std::get_if<rheometry::SteadySpeeds>(&schedule)) {
        return without_inertia(
            scene, plan, factor, steady->speeds.size(), false,
            [&](std::size_t k) { return steady->speeds[k]; }, progress);
    }
    const auto& history = std::get<rheometry::SpeedHistory>(schedule);
    if (!plan.transient) {
        return without_inertia(
            scene, plan, factor, history.row_times.size(), true,
            [&](std::size_t k) { return history.speed_at(history.row_times[k]); }, progress);
    }
    return with_inertia(scene, factor, history, progress);
}

} // namespace

void note_rest(RadialReport& report) {
    const auto rows = std::ranges::count_if(report.history.rows, &rheometry::TorqueRow::rests);
    if (rows > 0) {
        report.notes.push_back(
            "At rest the yield stress holds the fluid, and its flow law leaves the "
            "torque open between plus and minus the yield torque: at " +
            std::to_string(rows) + (rows == 1 ? " row" : " rows") +
            " without speed the error bar covers that range.");
    }
}

std::vector<std::size_t> rows_with_fields(const OutputSettings& output, std::size_t finished) {
    return output.fields ? rheometry::fields::spread_rows(
                               finished, static_cast<std::size_t>(output.field_rows))
                         : std::vector<std::size_t>{};
}

RadialReport solve_radial(const Scene& scene, const Plan& plan, const ProgressSink& progress) {
    RadialReport report = rows_of(scene, plan, progress);
    const auto rows = rows_with_fields(scene.output, report.history.rows.size());
    report.fields = gap_fields(scene, report, rows);
    return report;
}

} // namespace searle::solvers::radial
