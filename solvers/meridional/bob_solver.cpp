#include "solvers/meridional/bob_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/axisymmetric/section_shape.hpp"
#include "solvers/meridional/flow_fields.hpp"
#include "solvers/meridional/inertia_factor_curve.hpp"
#include "solvers/meridional/transient_secondary_flow.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/row_errors.hpp"
#include "solvers/stability/vortex_torque.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace searle::solvers::meridional {
namespace {

using axisymmetric::AxisymmetricReport;

/// Share of the accuracy that the creeping flow's torque may use where a factor multiplies it.
constexpr double factor_share = 0.5;

/// Where time is left out of the secondary flow (a yield-stress fluid in a ramp), this share of
/// what the steady secondary flow adds is claimed as error.
constexpr double unsteady_share = 0.5;

/// What vortices add to the torque of a narrow gap, over it, per Re / Re_c - 1 just past the onset.
constexpr double torque_slope_past_onset = 2.0;

/// The bob; that of a single gap with ends has a flat bottom.
geometry::DinBob bob_of(const Scene& scene) {
    return *axisymmetric::section_shape(scene.instrument).value().bob();
}

/// Stability is asked for where secondary flow carries at least this share of the torque.
constexpr double share_worth_asking = 0.03;

/// Rows past the onset of Taylor vortices along the bob: one flow of several was solved for.
void doubt_vortices(const Scene& scene, const Plan& plan, radial::RadialReport& solution) {
    std::size_t count = 0;
    std::vector<rheometry::TorqueRow>& rows = solution.history.rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double beyond = plan.rows[k].taylor_ratio - 1.0;
        if (beyond <= 0.0) {
            continue;
        }
        ++count;
        if (scene.solver.model == Model::automatic) {
            const double vortices = stability::vortex_torque_ratio(
                bob_of(scene).radius_ratio() - 1.0, plan.rows[k].taylor_ratio);
            rows[k].torque_error +=
                std::max(std::min(1.0, torque_slope_past_onset * beyond), vortices - 1.0) *
                std::abs(rows[k].torque);
        }
    }
    if (count > 0) {
        solution.notes.push_back(fmt::format(
            "{} row{} past the onset of Taylor vortices along the rotor: the torque is that of one "
            "of several axisymmetric flows{}.",
            count, count == 1 ? " lies" : "s lie",
            scene.solver.model == Model::automatic ? ", and what vortices may add is in its error"
                                                   : ""));
    }
}

void set_inertia(rheometry::EndEffect& end, const InertiaFactor& found) {
    end.with_inertia = end.end_factor * found.factor;
    end.with_inertia_error = end.error * found.factor + found.relative_error * end.with_inertia;
}

/// Says whether the steady flow at the fastest row would persist. May throw Interrupted.
void note_stability(const Plan& plan, InertiaFactorCurve& curve, radial::RadialReport& solution,
                    const ProgressSink& progress) {
    double fastest = 0.0;
    double share = 0.0;
    for (const RowForecast& row : plan.rows) {
        fastest = std::max(fastest, std::abs(row.speed));
        share = std::max(share, row.end_flow_share);
    }
    if (share < share_worth_asking) {
        return;
    }
    const auto rate = curve.disturbance_rate(fastest, progress);
    if (!rate) {
        return;
    }
    const double period = 2.0 * std::numbers::pi / std::max(rate->imag(), 1e-300);
    const std::string turning = rate->imag() > 1e-6 * fastest
                                    ? fmt::format(", oscillating with a period of {:.3g} s", period)
                                    : "";
    solution.notes.push_back(
        rate->real() > 0.0
            ? fmt::format(
                  "The steady flow at {:.4g} rad/s is unstable to axisymmetric disturbances, "
                  "which grow e-fold in {:.3g} s{}: an instrument's torque does not settle "
                  "on the value of the steady flow.",
                  fastest, 1.0 / rate->real(), turning)
            : fmt::format("The steady flow at {:.4g} rad/s is stable to axisymmetric disturbances: "
                          "the last of them dies e-fold in {:.3g} s{}.",
                          fastest, -1.0 / rate->real(), turning));
}

/// Replaces the fields of steady rows by those with the secondary flow.
void add_secondary_fields(const Scene& scene, InertiaFactorCurve& curve, AxisymmetricReport& report,
                          const ProgressSink& progress) {
    const geometry::DinBob bob = bob_of(scene);
    for (rheometry::fields::SectionFields& section : report.solution.fields) {
        const double speed = std::abs(section.speed);
        const FlowLevel* const found = speed == 0.0 ? nullptr : curve.flow_at(speed, progress);
        if (found == nullptr) {
            continue;
        }
        const double wall_rate =
            radial::steady_gap_flow({bob.bob_radius, bob.cup_radius}, scene.fluid.law, speed)
                .inner_wall_rate;
        auto whole = flow_fields(*found, found->state().velocity,
                                 {bob.bob_radius, section.speed, wall_rate}, scene.fluid.law);
        whole.row = section.row;
        whole.time = section.time;
        section = std::move(whole);
    }
}

/// Multiplies the torques (not of rows that a transient run has filled) and the end factors.
/// @param delay_share  of what secondary flow adds, for not following it in time
/// @return false where the flow's stability was asked for and interrupted; the rows are whole
bool apply_factors(const Scene& scene, const Plan& plan, AxisymmetricReport& report,
                   bool fills_torque, double delay_share, const ProgressSink& progress) {
    const geometry::DinBob bob = bob_of(scene);
    std::vector<rheometry::TorqueRow>& rows = report.solution.history.rows;
    std::vector<double> speeds;
    for (const rheometry::TorqueRow& row : rows) {
        speeds.push_back(row.speed);
    }
    InertiaFactorCurve curve(bob, scene.fluid.law, scene.fluid.density, speeds,
                             factor_share * scene.solver.accuracy, progress);
    if (curve.interrupted()) {
        std::size_t done = 0;
        while (done < rows.size() && (rows[done].speed == 0.0 || curve.has(rows[done].speed))) {
            ++done;
        }
        rows.resize(done);
        report.end_factor.resize(done);
        std::erase_if(report.ends,
                      [&](const rheometry::EndEffect& end) { return !curve.has(end.speed); });
        report.solution.fields.clear();
        report.solution.interrupted = true;
    }
    double largest = 1.0;
    double slowest_failure = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (rows[k].speed == 0.0) {
            continue;
        }
        const InertiaFactor found = curve.at(rows[k].speed);
        largest = std::max(largest, found.factor);
        if (found.levels == 0) {
            const double speed = std::abs(rows[k].speed);
            slowest_failure = slowest_failure > 0.0 ? std::min(slowest_failure, speed) : speed;
        }
        report.end_factor[k] *= found.factor;
        rows[k].steady_torque *= found.factor;
        if (fills_torque) {
            rows[k].torque *= found.factor;
            rows[k].torque_error = rows[k].torque_error * found.factor +
                                   (found.relative_error + delay_share * (found.factor - 1.0)) *
                                       std::abs(rows[k].torque);
        }
    }
    for (rheometry::EndEffect& end : report.ends) {
        set_inertia(end, curve.at(end.speed));
    }
    if (!report.solution.fields.empty() && !report.solution.transient) {
        try {
            add_secondary_fields(scene, curve, report, progress);
        } catch (const Interrupted&) {
            report.solution.fields.clear();
            report.solution.interrupted = true;
        }
    }
    radial::RadialReport& solution = report.solution;
    solution.refinements = std::max(solution.refinements, curve.levels());
    solution.unknowns = std::max(solution.unknowns, curve.unknowns());
    solution.linear_solves += curve.factorisations();
    if (curve.solutions() > 0) {
        report.division = curve.division();
    }
    solution.notes.push_back(
        fmt::format("Secondary flow multiplies the steady torque by up to {:.6g} ({} solution{} of "
                    "the flow with inertia).",
                    largest, curve.solutions(), curve.solutions() == 1 ? "" : "s"));
    if (slowest_failure > 0.0) {
        solution.notes.push_back(
            fmt::format("No steady secondary flow was found at {:.4g} rad/s, nor at any faster row "
                        "with an error of 100 %: those torques are creeping ones.",
                        slowest_failure));
        return true;
    }
    if (!solution.interrupted) {
        try {
            note_stability(plan, curve, solution, progress);
        } catch (const Interrupted&) {
            return false;
        }
    }
    return true;
}

/// Fills the rows from a run in time.
void run_in_time(const Scene& scene, const rheometry::SpeedHistory& history,
                 AxisymmetricReport& report, const ProgressSink& progress) {
    radial::RadialReport& solution = report.solution;
    TransientTorque run = transient_secondary_flow(
        bob_of(scene), scene.fluid.law, scene.fluid.density, history, scene.solver.accuracy,
        radial::rows_with_fields(scene.output, history.row_times.size()), progress);
    fill_from_run(run.torque, run.error, report);
    solution.fields = std::move(run.fields);
    solution.refinements = run.levels;
    solution.elements = run.elements;
    solution.time_steps = run.time_steps;
    report.division = run.division;
    solution.unknowns = run.unknowns;
    solution.linear_solves = run.linear_solves;
    solution.interrupted = run.interrupted;
    solution.reached = run.reached;
    solution.worst_relative_error = run.worst_relative_error;
    if (!run.stopped.empty()) {
        solution.notes.push_back(fmt::format("The run ends early: {}.", run.stopped));
    }
}

} // namespace

axisymmetric::EndEffectTable end_effects(const Scene& scene, std::span<const double> speeds,
                                         const ProgressSink& progress) {
    axisymmetric::EndEffectTable table = axisymmetric::end_effect_table(scene, speeds, progress);
    const auto shape = axisymmetric::section_shape(scene.instrument);
    if (scene.solver.secondary_flow == Switch::off || shape->bob() == nullptr ||
        table.interrupted) {
        return table;
    }
    // A table is short, and each of its speeds may be found or not.
    const InertiaFactorCurve curve(bob_of(scene), scene.fluid.law, scene.fluid.density, speeds,
                                   factor_share * scene.solver.accuracy, progress, speeds.size());
    std::erase_if(table.rows, [&](const auto& row) { return !curve.has(row.speed); });
    for (rheometry::EndEffect& row : table.rows) {
        const InertiaFactor found = curve.at(row.speed);
        set_inertia(row, found);
        table.reached = table.reached && found.reached;
    }
    table.interrupted = curve.interrupted();
    return table;
}

AxisymmetricReport solve_bob(const Scene& scene, const Plan& plan, const ProgressSink& progress) {
    AxisymmetricReport report = axisymmetric::solve_axisymmetric(scene, plan, progress);
    if (!plan.secondary_flow || report.solution.interrupted) {
        return report;
    }
    const rheometry::Conversion conversion =
        rheometry::conversion_for(scene.instrument, scene.conversion);
    const auto schedule = rheometry::schedule(scene.protocol, conversion);
    const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule);
    const bool yields = laws::flow::yield_stress(scene.fluid.law) > 0.0;
    const bool in_time = history != nullptr && plan.transient && !yields;
    const double delay_share = history != nullptr && plan.transient ? unsteady_share : 0.0;
    // The swirl's torques are no result of the case that asked for more.
    const auto without_rows = [&report] {
        report.solution.history.rows.clear();
        report.solution.fields.clear();
        report.end_factor.clear();
        report.ends.clear();
        report.solution.interrupted = true;
        report.solution.reached = false;
        return std::move(report);
    };
    bool knows_stability = true;
    try {
        if (!in_time || conversion.end_factor_provisional) {
            knows_stability = apply_factors(scene, plan, report, !in_time, delay_share, progress);
        }
    } catch (const Interrupted&) {
        return without_rows();
    }
    if (in_time && (report.solution.interrupted || !knows_stability)) {
        return without_rows();
    }
    if (plan.transient && yields && !report.solution.fields.empty()) {
        report.solution.notes.emplace_back(
            "The fields and their pictures show the swirl without the secondary flow, which is not "
            "followed in time with a yield stress.");
    }
    if (in_time) {
        run_in_time(scene, *history, report, progress);
    }
    doubt_vortices(scene, plan, report.solution);
    report.solution.interrupted = report.solution.interrupted || !knows_stability;
    if (!in_time || !report.solution.interrupted) {
        const bool is_complete = report.solution.history.rows.size() == plan.rows.size();
        report.solution.worst_relative_error =
            std::max(in_time ? report.solution.worst_relative_error : 0.0,
                     worst_relative_error(report.solution.history.rows));
        report.solution.reached = !report.solution.interrupted && is_complete &&
                                  report.solution.worst_relative_error <= scene.solver.accuracy;
    }
    return report;
}

} // namespace searle::solvers::meridional
