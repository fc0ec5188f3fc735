#pragma once

#include "rheometry/speed_history.hpp"
#include "rheometry/torque_history.hpp"

#include <span>
#include <vector>

namespace searle::solvers {

/// Largest estimated error of the rows' torques, relative to the torque itself or to a thousandth
/// of the largest one where that is more (a torque may pass through zero); 0 without rows. Rows at
/// rest are left out.
[[nodiscard]] double worst_relative_error(std::span<const rheometry::TorqueRow> rows);

/// True for each row at which the drive stands still and the torque is within what a fluid at rest
/// carries (rheometry::TorqueRow::rests).
/// @param torque  of the history's first rows
/// @param yield   what it carries at the most, >= 0, in the unit of the torque; 0: nothing rests
[[nodiscard]] std::vector<bool> rows_at_rest(std::span<const double> torque, double yield,
                                             const rheometry::SpeedHistory& history);

/// Whether the torque passes through zero between two rows with no jump or kink between them: what
/// is left of two torques that nearly cancel errs by shares of both, of steps and of elements, and
/// two levels may see those cancel too.
[[nodiscard]] bool turns_within_a_piece(std::span<const double> torque,
                                        const rheometry::SpeedHistory& history);

/// Error bar of a row at rest: from its torque, within +-yield, over all that a fluid at rest
/// carries.
[[nodiscard]] double error_at_rest(double torque, double yield);

/// Change of each row's torque from one level of resolution to the next, or of a neighbour where
/// that is more, relative to the larger of both torques: a row at which two levels happen to cross
/// is not exact.
/// Within one piece of the history, where the torque is smooth, and from the row at its start if
/// the speed does not jump there, a neighbour's absolute change counts as well; and steps that may
/// err by a share of what moves leave at least that share of a neighbour's torque: of a torque that
/// passes through zero no more is known.
/// @param before, after  torques of the history's first rows
/// @param tolerance      of the steps of the later level, relative
[[nodiscard]] std::vector<double> level_changes(std::span<const double> before,
                                                std::span<const double> after,
                                                const rheometry::SpeedHistory& history,
                                                double tolerance);

/// Errors of rows whose torque was found on levels of resolution in time and space: three times the
/// last change, because the coarser of two levels may err in the same direction as the finer one
/// (just after a jump; where vortices begin to grow, 2.6 times was seen); once two changes of a row
/// are known, later ones shrink at least as they did, of which half is believed, but the whole of
/// the last change is claimed.
/// @param change, before  level_changes of the last and the last but one level; `before` may have
///                        fewer rows
[[nodiscard]] std::vector<double> level_errors(std::span<const double> change,
                                               std::span<const double> before);

} // namespace searle::solvers
