#pragma once

#include <optional>
#include <string_view>

namespace searle::rheometry {

/// What a column of a data file can hold.
enum class ColumnQuantity {
    time,
    angular_velocity,
    torque,
    wall_speed,
    wall_force,
    shear_rate,
    shear_stress,
    angle,
    length,
    stress_constant, ///< stress per torque
    strain_constant  ///< strain per angle
};

/// SI units per unit of the text, e.g. 1e-3 for a torque in "mN.m", "[mN m]" or "(mNm)"; no value
/// for a text that is no unit of this quantity. A turning speed "1/min" means revolutions; "1/s" is
/// none, since it may mean radians as well as revolutions.
[[nodiscard]] std::optional<double> si_factor(ColumnQuantity quantity, std::string_view unit);

/// A few units of the quantity, for a message: "N.m, mN.m, uN.m".
[[nodiscard]] std::string_view usual_units(ColumnQuantity quantity);

/// True when the text is the unit of one of the quantities.
[[nodiscard]] bool is_data_unit(std::string_view text);

/// The text without blanks and without one pair of brackets, [ ] or ( ), around it.
[[nodiscard]] std::string_view without_brackets(std::string_view text);

} // namespace searle::rheometry
