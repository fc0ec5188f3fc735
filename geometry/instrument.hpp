#pragma once

#include "geometry/box.hpp"
#include "geometry/concentric_cylinders.hpp"
#include "geometry/din_bob.hpp"
#include "geometry/double_gap.hpp"

#include <string_view>
#include <variant>

namespace searle::geometry {

using Instrument = std::variant<ConcentricCylinders, DoubleGap, DinBob, Box>;

/// The instrument's name in case files: single-gap, double-gap, din-bob or box.
[[nodiscard]] std::string_view name_of(const Instrument& instrument);

/// True for the instruments whose drive turns (speed in rad/s, response a torque in N m);
/// false for the box, whose wall translates (speed in m/s, response a force in N).
[[nodiscard]] bool rotates(const Instrument& instrument);

/// The fluid beyond the ends of the gap is part of the instrument: a DIN bob, a single or double
/// gap with ends = true.
[[nodiscard]] bool has_ends(const Instrument& instrument);

/// The bob turns about another axis than the cup's: a single gap with an offset.
[[nodiscard]] bool is_eccentric(const Instrument& instrument);

} // namespace searle::geometry
