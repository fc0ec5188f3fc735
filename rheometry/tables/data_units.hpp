#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace searle::rheometry {

/// What a column of a data file can hold for a conversion.
enum class Quantity {
    time,
    angular_velocity,
    torque,
    wall_speed,
    wall_force,
    shear_rate,
    shear_stress,
    angle
};

/// SI units per unit, e.g. 1e-3 for a torque in "mN.m" or "mN m", for the spellings that
/// instruments and spreadsheets use: blank, point, middle dot or nothing between factors, a micro
/// sign or a u, brackets around it. A turning speed "1/min" means revolutions; "1/s" is refused for
/// it, since it may mean radians as well as revolutions.
[[nodiscard]] std::optional<double> si_factor(Quantity quantity, std::string_view unit);

/// The text without blanks and without one pair of brackets, [ ] or ( ), around it.
[[nodiscard]] std::string_view without_brackets(std::string_view text);

/// The spellings that si_factor takes, for a message: "N.m, mN.m, uN.m, ...".
[[nodiscard]] std::string accepted_units(Quantity quantity);

/// True when the text is the unit of one of the quantities.
[[nodiscard]] bool is_data_unit(std::string_view text);

} // namespace searle::rheometry
