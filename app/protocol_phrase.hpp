#pragma once

#include "rheometry/protocol.hpp"

#include <string>

namespace searle::app {

/// A phrase for people: "ramp from 0 to 100 1/s in 35 s, 100 points".
/// @param turning  the drive's speeds are rad/s; false: m/s, the box
[[nodiscard]] std::string protocol_phrase(const rheometry::Protocol& protocol, bool turning);

} // namespace searle::app
