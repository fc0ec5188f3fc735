#pragma once

#include "rheometry/torque_history.hpp"
#include "solvers/suspension/claimed_error.hpp"
#include "solvers/suspension/stress_sample.hpp"

#include <span>
#include <string>

namespace searle::solvers::suspension {

/// Mean of a held step after its start-up.
/// @param discard      strain to leave out; negative: found by a test on the stress
/// @param wall_area    m^2
[[nodiscard]] rheometry::TorqueRow row_of_hold(std::span<const StressSample> samples, bool walls,
                                               double discard, double wall_area,
                                               ClaimedError claimed);

/// Value at `time` of straight lines through the samples.
[[nodiscard]] rheometry::TorqueRow row_of_ramp(std::span<const StressSample> samples, bool walls,
                                               double time, double wall_area, ClaimedError claimed);

/// Widens the statistical errors of a ramp's rows by what differs from packing to packing and
/// changes too slowly for the few samples around a row: the stress that is not the isolated
/// spheres', over the rate, is taken as a straight line in time over the whole piece; a row's error
/// then also has the scatter of rows about it, and the error of the line.
/// @param piece            samples of one straight piece of the ramp
/// @param samples_per_row  > 0
void widen_by_piece(std::span<const StressSample> piece, bool walls, std::size_t samples_per_row,
                    std::span<rheometry::TorqueRow> rows);

/// A sentence on the rows that were averaged over too short a time for their scatter to be told
/// well, and how wide their bars are; empty when there is none.
/// @param accuracy a statistical error below it, relative, is not worth a word
[[nodiscard]] std::string note_on_scatter(std::span<const rheometry::TorqueRow> rows,
                                          double accuracy);

} // namespace searle::solvers::suspension
