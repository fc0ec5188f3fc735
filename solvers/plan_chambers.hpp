#pragma once

#include "geometry/instrument.hpp"
#include "solvers/plan_inertia.hpp"
#include "solvers/scene.hpp"

#include <array>

namespace searle::solvers {

/// How the fluid below and above a rotor answers to a change of the speed, of the whole instrument
/// (inertia in kg m^2); zeros for what has no ends. An estimate, for the plan: below, a disc of
/// the rotor's radius R that drives the fluid over a floor at the distance h at rest,
///   inertia = pi rho R^4 h / 6,  1 / decay time = nu ((pi / h)^2 + (3.8317 / R_cup)^2),
/// above, the same below a free surface around a shaft that turns along,
///   1 / decay time = nu ((pi / 2 h)^2 + (pi / (R_cup - R_shaft))^2),
/// nu with the tangent viscosity at the rate omega R / h.
/// @param speed  rad/s, > 0
[[nodiscard]] std::array<GapResponse, 2> chamber_responses(const geometry::Instrument& instrument,
                                                           const Fluid& fluid, double speed);

} // namespace searle::solvers
