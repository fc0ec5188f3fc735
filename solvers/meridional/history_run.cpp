#include "solvers/meridional/history_run.hpp"

#include "solvers/steps_before_stop.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::meridional {
namespace {

/// First step after a kink or jump, over the time to the next row.
constexpr double first_share = 1e-4;
/// Steps shorter than this share of the history are a flow that the level cannot hold.
constexpr double shortest_share = 1e-9;
/// Velocities below this share of the rotor's at the next row need no accuracy of their own.
constexpr double least_scale_share = 0.1;
/// Rows after a kink or jump that a step ends at: there the torque goes as the root of time, which
/// the polynomial within a step misses by the same on every level. Not with an uneven rotor: what
/// grows into vortices feels every change of the steps, and its levels part.
constexpr int rows_met_around_bob = 8;
/// Linear solves that a factorisation takes as long as, about.
constexpr double factorisation_work = 30.0;
constexpr double most_level_work = 6e7;
constexpr double most_overrun = 1.5;
constexpr double level_growth = 4.0;

} // namespace

bool may_follow(const HistoryRun& before) { return level_growth * before.work <= most_level_work; }

HistoryRun run_history(FlowLevel& level, const ScaledFluid& fluid, double reference_speed,
                       const rheometry::SpeedHistory& history, const RunSettings& settings,
                       const ProgressSink& progress) {
    HistoryRun run;
    const double duration = history.duration();
    const std::vector<double>& rows = history.row_times;
    const double first_row = rows.empty() ? duration : rows.front();
    const long factored_before = level.system().factorisations();
    double fraction = 0.0;
    const auto at_each_try = [&] {
        if (progress) {
            progress(fraction, "secondary flow in time");
        }
    };
    FlowStepper stepper(level.system(), fluid.material(), level.state(),
                        {.tolerance = settings.tolerance,
                         .first_step = first_share * first_row * reference_speed,
                         .shortest_step = shortest_share * duration * reference_speed,
                         .rotor_profile = settings.rotor_profile,
                         .at_each_try = at_each_try});
    const int rows_met = settings.rotor_profile.size() == 0 ? rows_met_around_bob : 0;
    std::size_t row = 0;
    const auto take_row = [&](double time) {
        run.torque.push_back(stepper.torque_at(time));
        ++row;
        if (std::ranges::binary_search(settings.field_rows, row)) {
            run.kept.push_back({row, stepper.velocity_at(time)});
        }
    };
    for (const auto& piece : history.pieces) {
        const double length = piece.end_time - piece.start_time;
        stepper.begin({.start_time = piece.start_time * reference_speed,
                       .speed = piece.start_speed / reference_speed,
                       .acceleration = (piece.end_speed - piece.start_speed) / length /
                                       (reference_speed * reference_speed)});
        const double end = piece.end_time * reference_speed;
        const bool stops = rows_met > 0 && piece.end_speed == 0.0 && piece.start_speed != 0.0;
        int rows_of_piece = 0;
        while (stepper.time() < end) {
            const double next_speed =
                row < rows.size() ? std::abs(history.speed_at(rows[row])) / reference_speed : 0.0;
            const double next_row = row < rows.size() && rows_of_piece < rows_met
                                        ? std::min(end, rows[row] * reference_speed)
                                        : end;
            double limit = next_row > stepper.time() ? next_row : end;
            if (stops && limit == end) {
                const double left = end - stepper.time();
                limit -= left - longest_before_stop(left, length * reference_speed, left);
            }
            const bool taken = stepper.step(limit, least_scale_share * next_speed);
            run.steps = stepper.steps();
            run.solves = stepper.solves();
            run.end_time = stepper.time() / reference_speed;
            run.work = static_cast<double>(level.space().unknowns()) *
                       (static_cast<double>(run.solves) +
                        factorisation_work *
                            static_cast<double>(level.system().factorisations() - factored_before));
            run.too_dear = run.work > most_overrun * most_level_work;
            if (!taken || run.too_dear) {
                level.set_state(stepper.state());
                return run;
            }
            while (row < rows.size() && rows[row] * reference_speed <= stepper.time()) {
                take_row(rows[row] * reference_speed);
                ++rows_of_piece;
            }
            fraction = run.end_time / duration;
        }
    }
    // Rounding of the last row's time must not lose it.
    while (row < rows.size()) {
        take_row(stepper.time());
    }
    run.end_time = duration;
    level.set_state(stepper.state());
    return run;
}

} // namespace searle::solvers::meridional
