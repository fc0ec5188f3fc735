#pragma once

#include <string>

namespace searle::rheometry::report {

/// "#rrggbb" of a share 0 ... 1 of a colour scale from dark blue over green to yellow: viridis,
/// which grows evenly in brightness, in print and with any kind of colour vision.
[[nodiscard]] std::string scale_colour(double share);

} // namespace searle::rheometry::report
