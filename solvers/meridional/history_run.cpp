#include "solvers/meridional/history_run.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::meridional {
namespace {

/// First step after a kink or jump, over the time to the next row.
constexpr double first_share = 1e-4;
/// Steps shorter than this share of the history are a flow that the level cannot hold.
constexpr double shortest_share = 1e-9;

} // namespace

HistoryRun run_history(FlowLevel& level, const ScaledFluid& fluid, double reference_speed,
                       const rheometry::SpeedHistory& history, double tolerance,
                       const ProgressSink& progress, const Eigen::VectorXd& rotor_profile,
                       long most_solves) {
    HistoryRun run;
    const double duration = history.duration();
    const std::vector<double>& rows = history.row_times;
    const double first_row = rows.empty() ? duration : rows.front();
    FlowStepper stepper(level.system(), fluid.material(), level.state(),
                        {.tolerance = tolerance,
                         .first_step = first_share * first_row * reference_speed,
                         .shortest_step = shortest_share * duration * reference_speed,
                         .rotor_profile = rotor_profile});
    std::size_t row = 0;
    for (const auto& piece : history.pieces) {
        const double length = piece.end_time - piece.start_time;
        stepper.begin({.start_time = piece.start_time * reference_speed,
                       .speed = piece.start_speed / reference_speed,
                       .acceleration = (piece.end_speed - piece.start_speed) / length /
                                       (reference_speed * reference_speed)});
        const double end = piece.end_time * reference_speed;
        while (stepper.time() < end) {
            const bool taken = stepper.step(end);
            run.steps = stepper.steps();
            run.solves = stepper.solves();
            run.end_time = stepper.time() / reference_speed;
            run.too_dear = run.solves > most_solves;
            if (!taken || run.too_dear) {
                level.set_state(stepper.state());
                return run;
            }
            while (row < rows.size() && rows[row] * reference_speed <= stepper.time()) {
                run.torque.push_back(stepper.torque_at(rows[row] * reference_speed));
                ++row;
            }
            if (progress) {
                progress(run.end_time / duration, "secondary flow in time");
            }
        }
    }
    // Rounding of the last row's time must not lose it.
    for (; row < rows.size(); ++row) {
        run.torque.push_back(stepper.torque_at(stepper.time()));
    }
    run.end_time = duration;
    level.set_state(stepper.state());
    return run;
}

} // namespace searle::solvers::meridional
