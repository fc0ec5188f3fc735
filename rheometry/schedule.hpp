#pragma once

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/protocol.hpp"
#include "rheometry/speed_history.hpp"

#include <variant>

namespace searle::rheometry {

/// The protocol as speeds of the drive: shear rates become speeds through the conversion, whose
/// definition of the rate is the one the case file's rates are meant in.
/// - ramp: one linear piece; rows at t = k duration / points, k = 1 ... points, the last at exactly
///   `duration`. Before t = 0 the drive turns at `from`, or stands still for StartState::rest.
/// - steps with a hold: a jump at the start of each step, the first from rest; a row at each end.
/// - steps with a hold in strain: the same, each held for the strain over its shear rate.
/// - steps without either: SteadySpeeds.
/// - segments: linear pieces, each from the speed at which the one before ended, the first from
/// rest.
/// @param protocol  valid: durations > 0, points >= 1, at least one step or segment
[[nodiscard]] std::variant<SteadySpeeds, SpeedHistory> schedule(const Protocol& protocol,
                                                                const Conversion& conversion);

} // namespace searle::rheometry
