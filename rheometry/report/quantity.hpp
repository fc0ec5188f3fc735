#pragma once

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/rheogram.hpp"

#include <string>

namespace searle::rheometry::report {

/// A column of the rheogram.
enum class Quantity { time, drive_speed, torque, shear_rate, shear_stress, viscosity };

/// How a quantity is named and measured.
struct QuantityLook {
    std::string name;    ///< "Shear stress"
    std::string symbol;  ///< "τ"
    std::string si_unit; ///< "Pa"
};

/// `rotates` is false for the box, whose drive has a wall speed and a force.
[[nodiscard]] QuantityLook look_of(Quantity quantity, bool rotates);

[[nodiscard]] double value_of(const RheogramPoint& point, Quantity quantity);

/// Statistical error of the shear stress, Pa, >= 0; 0 without particles, or where it is not known.
[[nodiscard]] double scatter_of(const RheogramPoint& point);

/// The numerical error estimate of a quantity and its scatter, SI, >= 0; 0 for what the drive
/// prescribes.
[[nodiscard]] double error_of(const RheogramPoint& point, Quantity quantity,
                              const Conversion& conversion);

/// |stress_error / shear_stress|; NaN at zero stress.
[[nodiscard]] double relative_error(const RheogramPoint& point);

/// The largest finite relative_error of the points; NaN when there is none.
[[nodiscard]] double largest_relative_error(const Rheogram& rheogram);

/// Largest finite |value| of a column, SI; 0 when there is none.
[[nodiscard]] double largest_value(const Rheogram& rheogram, Quantity quantity);

/// "Shear stress τ (mPa)".
[[nodiscard]] RichText axis_name(const QuantityLook& look, const DisplayUnit& unit);

/// Lines of text with all that is known of a point, for its tooltip.
[[nodiscard]] std::string point_tip(const RheogramPoint& point, bool rotates, bool has_time);

} // namespace searle::rheometry::report
