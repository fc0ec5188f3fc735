#pragma once

#include "geometry/din_bob.hpp"
#include "rheometry/report/drafting.hpp"

namespace searle::rheometry::report {

/// Half-section with cone, shaft, floor and free surface.
[[nodiscard]] Drafting draw_din_bob(const geometry::DinBob& instrument);

} // namespace searle::rheometry::report
