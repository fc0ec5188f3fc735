#pragma once

#include "geometry/concentric_cylinders.hpp"
#include "geometry/double_gap.hpp"
#include "rheometry/report/drafting.hpp"

namespace searle::rheometry::report {

/// Half-sections of the instruments whose ends are not part of the geometry.
[[nodiscard]] Drafting draw_single_gap(const geometry::ConcentricCylinders& instrument);
[[nodiscard]] Drafting draw_double_gap(const geometry::DoubleGap& instrument);

} // namespace searle::rheometry::report
