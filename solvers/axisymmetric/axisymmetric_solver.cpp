#include "solvers/axisymmetric/axisymmetric_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/axisymmetric/end_factor_curve.hpp"
#include "solvers/axisymmetric/swirl_fields.hpp"
#include "solvers/axisymmetric/swirl_history.hpp"
#include "solvers/axisymmetric/swirl_level.hpp"
#include "solvers/axisymmetric/swirl_response.hpp"
#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace searle::solvers::axisymmetric {
namespace {

std::vector<double> speeds_of(const Plan& plan) {
    std::vector<double> speeds;
    for (const RowForecast& row : plan.rows) {
        speeds.push_back(row.speed);
    }
    return speeds;
}

rheometry::TorqueRow steady_row(const Scene& scene, const RowForecast& forecast,
                                const EndFactorCurve::Value& ends) {
    const radial::SteadyInstrumentFlow flow =
        radial::steady_instrument_flow(scene.instrument, scene.fluid.law, forecast.speed);
    const double torque = ends.end_factor * flow.torque;
    return {.time = forecast.time,
            .speed = forecast.speed,
            .torque = torque,
            .torque_error = std::abs(torque) * (ends.relative_error + flow.relative_error),
            .steady_torque = torque,
            .yield_radius = flow.yield_radius,
            .rotor_wall_rate = flow.rotor_wall_rate};
}

/// Rows of a yield-stress fluid without speed, and without inertia: the torque that the motion
/// before them stopped with. Nothing is changed when `progress` throws.
/// @param sign  of the motion before the first row, 0: none
void settle_rows_at_rest(const SectionShape& shape, const Scene& scene, double sign,
                         std::vector<rheometry::TorqueRow>& rows, const ProgressSink& progress) {
    if (std::ranges::none_of(rows, [](const auto& row) { return row.speed == 0.0; })) {
        return;
    }
    const double yield = stopping_torque(shape, scene.fluid.law, progress);
    for (rheometry::TorqueRow& row : rows) {
        if (row.speed != 0.0) {
            sign = std::copysign(1.0, row.speed);
            continue;
        }
        row.rests = true;
        row.torque = sign * yield;
        row.torque_error = error_at_rest(row.torque, yield);
    }
}

/// Adds what inertia may do to rows that were solved without it.
void add_lag(const Plan& plan, std::vector<rheometry::TorqueRow>& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].torque_error += left_out_margin * plan.rows[k].lag_share * std::abs(rows[k].torque);
    }
}

/// Adds what secondary flow may do.
void add_end_flow(const Plan& plan, std::vector<rheometry::TorqueRow>& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].torque_error +=
            left_out_margin * plan.rows[k].end_flow_share * std::abs(rows[k].torque);
    }
}

/// The creeping flow at some rows: fields converge more slowly than the torque.
std::vector<rheometry::fields::SectionFields>
steady_fields(const SectionShape& shape, const Scene& scene,
              const std::vector<rheometry::TorqueRow>& rows, std::span<const std::size_t> chosen,
              const ProgressSink& progress) {
    constexpr double sharper = 0.2;
    std::vector<rheometry::fields::SectionFields> sections;
    for (const std::size_t number : chosen) {
        const rheometry::TorqueRow& row = rows[number - 1];
        if (row.speed == 0.0) {
            continue;
        }
        const CreepingSwirl swirl =
            creeping_swirl(shape, scene.fluid.law, std::abs(row.speed),
                           {.accuracy = sharper * scene.solver.accuracy}, progress);
        auto section =
            swirl_fields({.mesh = swirl.level->mesh(),
                          .length = shape.unit(),
                          .degree = swirl.level->rotation_space().degree(),
                          .rotation = swirl.level->rotation(),
                          .speed = row.speed,
                          .rate_scale = laws::flow::rate(scene.fluid.law, swirl.stress_scale),
                          .stress_function = &swirl.level->stress_function(),
                          .stress_scale = swirl.stress_scale},
                         scene.fluid.law);
        section.row = number;
        section.time = row.time;
        sections.push_back(std::move(section));
    }
    return sections;
}

/// Rows with inertia in place of the steady ones, for laws that are not Newtonian.
void follow_swirl(const SectionShape& shape, const Scene& scene,
                  const rheometry::SpeedHistory& history, AxisymmetricReport& report,
                  const ProgressSink& progress) {
    radial::RadialReport& solution = report.solution;
    std::vector<double> steady;
    std::vector<double> steady_error;
    for (const rheometry::TorqueRow& row : solution.history.rows) {
        steady.push_back(row.torque);
        steady_error.push_back(row.torque_error);
    }
    SwirlHistory swirl = swirl_history(
        shape, scene.fluid.law, scene.fluid.density, history, scene.solver.accuracy,
        {steady, steady_error},
        radial::rows_with_fields(scene.output, solution.history.rows.size()), progress);
    fill_from_run(swirl.torque, swirl.error, report);
    solution.interrupted = swirl.interrupted;
    solution.refinements = swirl.levels;
    solution.elements = swirl.elements;
    solution.unknowns = swirl.unknowns;
    solution.time_steps = swirl.time_steps;
    solution.linear_solves += swirl.newton_steps;
    solution.fields = std::move(swirl.fields);
    report.division = std::move(swirl.division);
    if (!swirl.stopped.empty()) {
        solution.notes.push_back("Swirl in time: " + swirl.stopped + ".");
    }
    for (std::size_t k = 0; k < solution.history.rows.size(); ++k) {
        solution.history.rows[k].rests = swirl.rests[k];
    }
}

std::string range_text(const std::vector<double>& factors) {
    // Rows at rest have no end effect and hold 1.
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const double factor : factors) {
        if (factor != 1.0) {
            least = std::min(least, factor);
            most = std::max(most, factor);
        }
    }
    return most - least < 1e-9 ? fmt::format("{:.6g}", most)
                               : fmt::format("{:.6g} to {:.6g}", least, most);
}

/// What stresses converted with a given end factor are off by, if it is worth telling.
std::string misreading_text(const Scene& scene, const std::vector<double>& factors) {
    constexpr double worth_telling = 2e-3;
    const rheometry::Conversion conversion =
        rheometry::conversion_for(scene.instrument, scene.conversion);
    if (conversion.end_factor_provisional) {
        return {};
    }
    const double used = conversion.end_factor;
    double most = 0.0;
    for (const double factor : factors) {
        if (factor != 1.0 && std::abs(factor / used - 1.0) > std::abs(most)) {
            most = factor / used - 1.0;
        }
    }
    return std::abs(most) < worth_telling
               ? std::string{}
               : fmt::format(" The conversion uses {:.6g}, with which stresses read up to {:.2g} % "
                             "too {}; conversion.end_factor = \"computed\" uses the bob's own.",
                             used, 100.0 * std::abs(most), most > 0.0 ? "high" : "low");
}

/// What the energies say of the end factor at a speed.
std::string bounds_text(double speed, const EndFactorCurve::Value& value) {
    // Near the plastic limit the dual energy may say nothing.
    constexpr double of_use = 2.0;
    if (!(value.lower > 0.0) || value.upper > of_use * value.lower) {
        return fmt::format("at {:.4g} rad/s the energies give no useful bounds.", speed);
    }
    return fmt::format("at {:.4g} rad/s it is between {:.6g} and {:.6g} by the energy bounds.",
                       speed, value.lower, value.upper);
}

} // namespace

void fill_from_run(std::span<const double> torque, std::span<const double> error,
                   AxisymmetricReport& report) {
    std::vector<rheometry::TorqueRow>& rows = report.solution.history.rows;
    rows.resize(std::min(rows.size(), torque.size()));
    report.end_factor.resize(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].torque = torque[k];
        rows[k].torque_error = error[k];
    }
    report.solution.transient = true;
}

AxisymmetricReport solve_axisymmetric(const Scene& scene, const Plan& plan,
                                      const ProgressSink& progress) {
    const SectionShape shape = section_shape(scene.instrument).value();
    const double accuracy = scene.solver.accuracy;
    AxisymmetricReport report;
    radial::RadialReport& solution = report.solution;
    std::vector<rheometry::TorqueRow>& rows = solution.history.rows;
    {
        const std::vector<double> speeds = speeds_of(plan);
        const double rate_per_speed =
            rheometry::conversion_for(scene.instrument, scene.conversion).rate_per_speed;
        const EndFactorCurve ends(shape, scene.fluid.law, speeds, 0.5 * accuracy, progress);
        for (const RowForecast& forecast : plan.rows) {
            if (forecast.speed != 0.0 && !ends.has(forecast.speed)) {
                break;
            }
            const EndFactorCurve::Value value =
                forecast.speed == 0.0 ? EndFactorCurve::Value{} : ends.at(forecast.speed);
            rows.push_back(steady_row(scene, forecast, value));
            report.end_factor.push_back(value.end_factor);
            if (forecast.speed != 0.0) {
                const auto bound = [](double each) {
                    return each > 0.0 ? each : std::numeric_limits<double>::quiet_NaN();
                };
                report.ends.push_back({.speed = forecast.speed,
                                       .shear_rate = rate_per_speed * forecast.speed,
                                       .end_factor = value.end_factor,
                                       .error = value.end_factor * value.relative_error,
                                       .lower = bound(value.lower),
                                       .upper = bound(value.upper)});
            }
        }
        solution.elements = ends.elements();
        solution.refinements = ends.levels();
        solution.linear_solves = ends.newton_steps();
        solution.unknowns = ends.unknowns();
        report.division = ends.division();
        if (ends.solutions() > 0 && !ends.interrupted()) {
            const auto fastest =
                *std::max_element(speeds.begin(), speeds.end(), [](double one, double other) {
                    return std::abs(one) < std::abs(other);
                });
            solution.notes.push_back(fmt::format(
                "End factor of the creeping flow c_L = {} (computed; {} solution{}); {}{}",
                range_text(report.end_factor), ends.solutions(), ends.solutions() == 1 ? "" : "s",
                bounds_text(fastest, ends.at(fastest)), misreading_text(scene, report.end_factor)));
        }
        solution.interrupted = ends.interrupted();
    }
    if (solution.interrupted && plan.transient) {
        // Rows with inertia start from the steady ones, which are none of the answer.
        rows.clear();
        report.end_factor.clear();
        report.ends.clear();
    }

    const auto schedule = rheometry::schedule(
        scene.protocol, rheometry::conversion_for(scene.instrument, scene.conversion));
    const auto* newtonian = std::get_if<laws::flow::Newtonian>(&scene.fluid.law);
    // Then the solver of the secondary flow runs the history, and these rows are only its start.
    const bool followed_in_time =
        plan.secondary_flow && plan.transient && laws::flow::yield_stress(scene.fluid.law) == 0.0;
    if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule);
        history != nullptr && !followed_in_time) {
        if (plan.transient && newtonian != nullptr && !solution.interrupted) {
            const TransientSwirl swirl = transient_swirl(shape, newtonian->viscosity,
                                                         scene.fluid.density, *history, accuracy);
            fill_from_run(swirl.torque, swirl.error, report);
            const auto chosen = radial::rows_with_fields(scene.output, rows.size());
            if (!chosen.empty()) {
                solution.fields = transient_fields(shape, newtonian->viscosity, scene.fluid.density,
                                                   *history, swirl.resolution, chosen);
            }
            solution.elements = swirl.elements;
            // Exact in time: a step from row to row and from piece to piece.
            solution.time_steps =
                static_cast<long>(history->row_times.size() + history->pieces.size());
            solution.refinements = swirl.levels;
            solution.unknowns = swirl.unknowns;
            report.division = swirl.division;
        } else if (plan.transient && !solution.interrupted) {
            follow_swirl(shape, scene, *history, report, progress);
        } else {
            add_lag(plan, rows);
        }
    }
    if (!solution.transient && !followed_in_time && !solution.interrupted) {
        try {
            if (laws::flow::yield_stress(scene.fluid.law) > 0.0) {
                const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule);
                const double before = history != nullptr ? history->initial_speed : 0.0;
                settle_rows_at_rest(shape, scene, before == 0.0 ? 0.0 : std::copysign(1.0, before),
                                    rows, progress);
            }
            solution.fields = steady_fields(
                shape, scene, rows, radial::rows_with_fields(scene.output, rows.size()), progress);
        } catch (const Interrupted&) {
            const auto unsettled = std::ranges::find_if(
                rows, [](const auto& row) { return row.speed == 0.0 && !row.rests; });
            if (laws::flow::yield_stress(scene.fluid.law) > 0.0) {
                rows.erase(unsettled, rows.end());
                report.end_factor.resize(rows.size());
            }
            solution.interrupted = true;
        }
    }
    if (!plan.secondary_flow && scene.solver.secondary_flow == Switch::automatic) {
        add_end_flow(plan, rows);
    }

    radial::note_rest(solution);
    solution.worst_relative_error = worst_relative_error(rows);
    solution.reached = !solution.interrupted && rows.size() == plan.rows.size() &&
                       solution.worst_relative_error <= accuracy;
    return report;
}

} // namespace searle::solvers::axisymmetric
