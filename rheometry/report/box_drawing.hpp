#pragma once

#include "geometry/box.hpp"
#include "rheometry/report/drafting.hpp"

namespace searle::rheometry::report {

/// Oblique view of the box with its moving wall, its velocity profile and its three dimensions.
/// @param periodic  without walls, between images of itself that move
[[nodiscard]] Drafting draw_box(const geometry::Box& instrument, bool periodic = false);

} // namespace searle::rheometry::report
