#pragma once

#include <string_view>

namespace searle::rheometry {

/// The part of a rheogram's regime ("laminar", "partly-sheared+lag") in which the torque is not
/// that of the steady laminar flow of the law alone: lag, taylor-vortices or end-flow. Empty where
/// there is none, and for an empty regime.
[[nodiscard]] std::string_view disturbance_in(std::string_view regime);

} // namespace searle::rheometry
