#pragma once

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/protocol.hpp"
#include "rheometry/speed_history.hpp"

#include <variant>

namespace searle::rheometry {

/// The protocol as speeds of the drive: shear rates become speeds through the conversion.
[[nodiscard]] std::variant<SteadySpeeds, SpeedHistory> schedule(const Protocol& protocol,
                                                                const Conversion& conversion);

} // namespace searle::rheometry
