#include "solvers/meridional/transient_secondary_flow.hpp"

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/meridional/history_run.hpp"
#include "solvers/meridional/steady_secondary_flow.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/row_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::meridional {
namespace {

constexpr std::array<FlowResolution, 6> resolutions{
    {{.degree = 4, .smallest = 5e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 5, .smallest = 5e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 6, .smallest = 5e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 8, .smallest = 1e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 9, .smallest = 2e-3, .largest = 0.25, .beside = 2.0},
     {.degree = 10, .smallest = 5e-4, .largest = 0.125, .beside = 1.0}}};
/// Tolerance of a step on the first level over the accuracy, and what it falls by with each level.
constexpr double first_tolerance = 0.3;
constexpr double tolerance_fall = 0.3;
/// Of the corner that a power law has at rest, over the rate at the wall at the fastest speed.
constexpr double rounding = 1e-5;
constexpr double creeping_tolerance = 1e-10; ///< of the energy
/// Torques are judged against themselves, or against this share of the largest one.
constexpr double least_scale = 1e-3;

double largest_of(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    return largest;
}

/// Torque of the creeping flow on a level, in the units of the system; 0 where it is not found.
double creeping_torque_of(FlowLevel& level, const ScaledFluid& fluid) {
    level.start_from_rest();
    const FlowMaterial creeping = fluid.material(0.0);
    return level.solve_creeping(creeping.law, creeping_tolerance) ? level.steady_torque(creeping)
                                                                  : 0.0;
}

/// The level's state becomes the steady flow at `speed`, in units of the reference speed. False
/// where that is not found.
bool start_steadily(FlowLevel& level, SteadySecondaryFlow& steady, const ScaledFluid& at_speed,
                    double speed, double reference_speed, double accuracy) {
    if (steady.at(std::abs(speed)).levels == 0) {
        return false;
    }
    level.start_from_rest();
    level.start_from(*steady.finest());
    if (!level.solve_steady(at_speed.material(), accuracy)) {
        return false;
    }
    FlowState state = level.state();
    state.velocity *= std::abs(speed) / reference_speed;
    if (speed < 0.0) {
        state.velocity.col(static_cast<Eigen::Index>(Component::rotation)) *= -1.0;
    }
    // The stepper finds the pressure that belongs to the velocity.
    state.pressure.setZero();
    level.set_state(std::move(state));
    return true;
}

} // namespace

TransientTorque transient_secondary_flow(const geometry::DinBob& bob,
                                         const laws::flow::AnyFlowLaw& law, double density,
                                         const rheometry::SpeedHistory& history, double accuracy,
                                         std::span<const std::size_t> field_rows,
                                         const ProgressSink& progress) {
    TransientTorque result;
    const double reference_speed = history.fastest_speed();
    const auto wall_rate_at = [&](double speed) {
        return radial::steady_gap_flow({bob.bob_radius, bob.cup_radius}, law, std::abs(speed))
            .inner_wall_rate;
    };
    const double wall_rate = wall_rate_at(reference_speed);
    SteadySecondaryFlow steady(bob, law, density, accuracy);
    // What the elements at the bob's edges miss is the same from degree to degree, so the levels do
    // not show it; the creeping flow, whose torque is known within bounds, does.
    const double exact_creeping =
        axisymmetric::creeping_torque(bob, law, reference_speed,
                                      {.accuracy = 0.1 * accuracy, .certified = false})
            .torque;
    double tolerance = first_tolerance * accuracy;
    std::vector<double> change_before;
    const std::size_t rows = history.row_times.size();
    try {
        HistoryRun last;
        for (const FlowResolution& resolution : resolutions) {
            if (result.levels > 1 && !may_follow(last)) {
                break;
            }
            const ScaledFluid fluid(law, density, bob.bob_radius, reference_speed, wall_rate,
                                    rounding);
            FlowLevel level(bob, resolution);
            const double scale =
                2.0 * std::numbers::pi * std::pow(bob.bob_radius, 3) * fluid.stress_scale();
            const double creeping = scale * creeping_torque_of(level, fluid);
            const double correction = creeping > 0.0 ? exact_creeping / creeping : 1.0;
            if (history.initial_speed != 0.0) {
                const double own_rate = wall_rate_at(history.initial_speed);
                if (!start_steadily(level, steady,
                                    {law, density, bob.bob_radius, std::abs(history.initial_speed),
                                     own_rate, rounding * wall_rate / own_rate},
                                    history.initial_speed, reference_speed, tolerance)) {
                    // The level is too coarse to hold the flow; the next one may.
                    result.stopped = fmt::format(
                        "the steady flow at {:.4g} rad/s that it starts from was not found",
                        history.initial_speed);
                    continue;
                }
            } else {
                level.set_state(rest(level.space()));
            }
            const HistoryRun run =
                run_history(level, fluid, reference_speed, history,
                            {.tolerance = tolerance, .field_rows = field_rows}, progress);
            result.linear_solves += run.solves;
            last = run;
            if (run.too_dear && result.levels > 0) {
                result.stopped =
                    fmt::format("level {} took more work than a level may", result.levels + 1);
                break;
            }
            std::vector<double> torque;
            for (const double each : run.torque) {
                torque.push_back(correction * scale * each);
            }
            ++result.levels;
            result.elements = static_cast<int>(level.mesh().elements.size());
            result.unknowns = level.space().unknowns();
            result.division = {level.lines(), level.space().degree()};
            result.time_steps = run.steps;
            result.fields = flow_fields_at_rows(
                level, run.kept, {bob.bob_radius, reference_speed, wall_rate}, law, history);
            const bool complete = torque.size() == rows;
            result.stopped =
                complete ? std::string{}
                         : fmt::format("the flow could not be followed beyond t = {:.4g} s: {}",
                                       run.end_time,
                                       run.too_dear ? "it took more work than a level may"
                                                    : "its time steps became too short");
            const std::vector<double> before = std::exchange(result.torque, torque);
            const std::vector<double> change =
                level_changes(before, result.torque, history, tolerance);
            const double largest = largest_of(result.torque);
            double worst = result.levels == 1 ? 1.0 : 0.0;
            result.error.assign(result.torque.size(), largest);
            const std::vector<double> error = level_errors(change, change_before);
            for (std::size_t k = 0; k < change.size(); ++k) {
                result.error[k] = error[k] + std::abs((correction - 1.0) * torque[k]);
                const double against = std::max(std::abs(result.torque[k]), least_scale * largest);
                worst = std::max(worst, against > 0.0 ? result.error[k] / against : 0.0);
            }
            change_before = change;
            result.worst_relative_error = worst;
            result.reached = complete && result.levels > 1 && worst <= accuracy;
            if (result.reached || run.too_dear) {
                break;
            }
            tolerance *= tolerance_fall;
        }
    } catch (const Interrupted&) {
        result.interrupted = true;
        result.reached = false;
    }
    return result;
}

} // namespace searle::solvers::meridional
