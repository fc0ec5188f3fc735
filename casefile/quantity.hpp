#pragma once

#include "casefile/unit.hpp"

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace searle::casefile {

/// A kind of physical quantity that a key asks for.
struct QuantityKind {
    std::string_view name;    ///< with its article: "a length"
    std::string_view si_unit; ///< "m"; the unit that values are stored in and written with
    Dimension dimension;
    std::string_view usual_units; ///< a few, for messages and the reference
};

inline constexpr QuantityKind length{"a length", "m", {.length = 1}, "mm, um, m"};
inline constexpr QuantityKind angle{"an angle", "rad", {.angle = 1}, "deg, rad"};
inline constexpr QuantityKind duration{"a time", "s", {.time = 1}, "s, ms, min, h"};
inline constexpr QuantityKind density{
    "a density", "kg/m^3", {.length = -3, .mass = 1}, "kg/m^3, g/cm^3"};
inline constexpr QuantityKind viscosity{
    "a dynamic viscosity", "Pa.s", {.length = -1, .mass = 1, .time = -1}, "Pa.s, mPa.s, cP"};
inline constexpr QuantityKind stress{
    "a stress", "Pa", {.length = -1, .mass = 1, .time = -2}, "Pa, kPa"};
/// Pa s^n: its dimension depends on the flow index, so it has a rule of its own. In a Dimension it
/// is the stress at a rate of 1 1/s.
inline constexpr QuantityKind consistency{
    "a consistency", "Pa.s^n", {.length = -1, .mass = 1, .time = -2}, "Pa.s^n, mPa.s^n"};
inline constexpr QuantityKind shear_rate{"a shear rate", "1/s", {.time = -1}, "1/s"};
inline constexpr QuantityKind angular_velocity{
    "an angular velocity", "rad/s", {.time = -1, .angle = 1}, "rad/s, rpm, deg/s"};
inline constexpr QuantityKind speed{"a speed", "m/s", {.length = 1, .time = -1}, "m/s, mm/s"};
inline constexpr QuantityKind acceleration{
    "an acceleration", "m/s^2", {.length = 1, .time = -2}, "m/s^2"};
inline constexpr QuantityKind temperature{"a temperature", "K", {.temperature = 1}, "degC, K"};
inline constexpr QuantityKind energy{
    "an energy", "J", {.length = 2, .mass = 1, .time = -2}, "J, zJ"};
inline constexpr QuantityKind voltage{
    "a voltage", "V", {.length = 2, .mass = 1, .time = -3, .current = -1}, "mV, V"};
inline constexpr QuantityKind spring_stiffness{
    "a stiffness", "N/m", {.mass = 1, .time = -2}, "N/m, mN/m"};
inline constexpr QuantityKind dashpot{"a damping", "kg/s", {.mass = 1, .time = -1}, "kg/s, N.s/m"};
inline constexpr QuantityKind concentration{
    "a concentration", "mol/m^3", {.length = -3, .amount = 1}, "mol/l, mmol/l, mol/m^3"};
inline constexpr QuantityKind fraction{"a fraction", "1", {}, "%"};

struct Quantity {
    double value{};     ///< SI
    std::size_t kind{}; ///< which of the kinds that were asked for
};

/// Why a text is not one of the quantities asked for: fragments of a message.
struct QuantityFault {
    std::string problem;    ///< "has no unit", "is a time"
    std::string suggestion; ///< a unit or a text that may have been meant
};

/// Reads "14 mm", "1e-3 Pa.s", "20 degC", "0.5 Pa.s^n" as one of `kinds`. Decimal point only; the
/// number is finite; a power of ten in the unit costs no rounding.
[[nodiscard]] std::variant<Quantity, QuantityFault>
parse_quantity(std::string_view text, std::span<const QuantityKind> kinds);

/// The SI value as text that reads back to the same bits: "0.014 m"; a fraction is a bare "0.001".
[[nodiscard]] std::string si_text(double value, const QuantityKind& kind);

/// The number in the fewest digits that read back to the same bits.
[[nodiscard]] std::string shortest(double value);

} // namespace searle::casefile
