#pragma once

#include "rheometry/torque_history.hpp"
#include "solvers/suspension/stress_sample.hpp"

#include <span>
#include <string>

namespace searle::solvers::suspension {

/// How long the steps are at an asked accuracy, against those that were measured
/// (docs/suspension.md): 1 at 2e-3.
[[nodiscard]] double step_scale(double accuracy);

/// What is claimed as numerical error of the step, as shares of parts of the stress; above what was
/// measured (docs/suspension.md).
struct ClaimedError {
    double forces{}; ///< of contacts, colloid and thermal motion
    double films{};  ///< of the hydrodynamic part
};
[[nodiscard]] ClaimedError claimed_error(double accuracy, bool films);

/// Mean of a held step after its start-up.
/// @param discard      strain to leave out; negative: found by a test on the stress
/// @param wall_area    m^2
[[nodiscard]] rheometry::TorqueRow row_of_hold(std::span<const StressSample> samples, bool walls,
                                               double discard, double wall_area,
                                               ClaimedError claimed);

/// Value at `time` of straight lines through the samples.
[[nodiscard]] rheometry::TorqueRow row_of_ramp(std::span<const StressSample> samples, bool walls,
                                               double time, double wall_area, ClaimedError claimed);

/// A sentence on the rows that were averaged over too short a time for their scatter to be told
/// well, and how wide their bars are; empty when there is none.
/// @param accuracy a statistical error below it, relative, is not worth a word
[[nodiscard]] std::string note_on_scatter(std::span<const rheometry::TorqueRow> rows,
                                          double accuracy);

} // namespace searle::solvers::suspension
