#pragma once

#include "rheometry/torque_history.hpp"

#include <span>

namespace searle::solvers {

/// Largest estimated error of the rows' torques, relative to the torque itself or to a thousandth of
/// the largest one where that is more (a torque may pass through zero); 0 without rows.
[[nodiscard]] double worst_relative_error(std::span<const rheometry::TorqueRow> rows);

} // namespace searle::solvers
