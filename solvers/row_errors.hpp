#pragma once

#include "rheometry/torque_history.hpp"

#include <span>
#include <vector>

namespace searle::solvers {

/// Largest estimated error of the rows' torques, relative to the torque itself or to a thousandth
/// of the largest one where that is more (a torque may pass through zero); 0 without rows.
[[nodiscard]] double worst_relative_error(std::span<const rheometry::TorqueRow> rows);

/// Change of each row from one level of resolution to the next, or of a neighbour where that is
/// more: a row at which two levels happen to cross is not exact.
[[nodiscard]] std::vector<double> level_changes(std::span<const double> before,
                                                std::span<const double> after);

} // namespace searle::solvers
