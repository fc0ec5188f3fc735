#pragma once

#include "rheometry/torque_history.hpp"
#include "solvers/suspension/stress_sample.hpp"

#include <span>

namespace searle::solvers::suspension {

/// Share of the particles' part of the stress that is claimed as numerical error of step and grid
/// at an asked accuracy of 1e-3; docs/suspension.md has the measurements behind it.
inline constexpr double numerical_share = 0.01;

/// Mean of a held step after its start-up.
/// @param discard      strain to leave out; negative: found by a test on the stress
/// @param wall_area    m^2  @param claimed share of the particles' stress claimed as error
[[nodiscard]] rheometry::TorqueRow row_of_hold(std::span<const StressSample> samples, bool walls,
                                               double discard, double wall_area, double claimed);

/// Value at `time` of straight lines through the samples.
[[nodiscard]] rheometry::TorqueRow row_of_ramp(std::span<const StressSample> samples, bool walls,
                                               double time, double wall_area, double claimed);

} // namespace searle::solvers::suspension
