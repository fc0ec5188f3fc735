#pragma once

#include "rheometry/speed_history.hpp"
#include "solvers/meridional/flow_fields.hpp"
#include "solvers/meridional/flow_level.hpp"
#include "solvers/meridional/flow_material.hpp"
#include "solvers/meridional/flow_stepper.hpp"
#include "solvers/progress.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace searle::solvers::meridional {

/// One level's run through a speed history.
struct HistoryRun {
    /// At each row up to the end or to where the run got stuck: torque over
    /// 2 pi stress scale radius^3.
    std::vector<double> torque;
    double end_time{}; ///< s; the history's duration unless it got stuck
    long steps{};
    long solves{};
    /// Unknowns times (linear solves and what factorisations take of their time): about 0.6
    /// microseconds each.
    double work{};
    bool too_dear{};               ///< it ended because it took more work than a level may
    std::vector<RowVelocity> kept; ///< of the rows asked for, as far as they were reached
};

/// How a level is run.
struct RunSettings {
    double tolerance{}; ///< of the velocity's error in one step, over the largest velocity
    std::span<const std::size_t> field_rows; ///< rows whose flow is kept, from 1, increasing
    Eigen::VectorXd rotor_profile{};         ///< see StepperSettings
};

/// Ends where it is when it takes more work than a level may.
/// @param level      its state is the flow before t = 0, in units of the reference speed; on return
///                   the one at end_time
/// @param fluid      at the reference speed
/// @param reference_speed  rad/s, > 0
/// May throw Interrupted.
[[nodiscard]] HistoryRun run_history(FlowLevel& level, const ScaledFluid& fluid,
                                     double reference_speed, const rheometry::SpeedHistory& history,
                                     const RunSettings& settings, const ProgressSink& progress);

/// Whether the next level may be expected to take no more work than a level may, about half a
/// minute.
[[nodiscard]] bool may_follow(const HistoryRun& before);

} // namespace searle::solvers::meridional
