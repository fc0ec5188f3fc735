#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace searle::rheometry::report {

/// A number with at most `digits` significant digits for running text: "0.0125", "1.2 × 10⁻⁵".
/// Trailing zeros are dropped, minus is U+2212, zero has no sign; not finite: an en dash.
[[nodiscard]] std::string significant(double value, int digits);

/// The same with exactly `digits` significant digits, trailing zeros kept.
[[nodiscard]] std::string significant_padded(double value, int digits);

/// The digits of `value` that an error of size `error` leaves: down to the second significant digit
/// of the error, 3 to 15 digits in all; 10 digits where the error is 0 or unknown.
[[nodiscard]] std::string rounded_to_error(double value, double error);

/// As many decimals as the numbers of a column need to show seven significant digits of the
/// largest, so that their points stand below each other; nothing where the column spans too many
/// decades.
[[nodiscard]] std::optional<int> common_decimals(std::span<const double> values);

/// A number with a fixed count of decimals.
[[nodiscard]] std::string with_decimals(double value, int decimals);

/// A relative number as percent, "0.1 %"; below 1e-5 as a number, "1.2 × 10⁻⁸".
[[nodiscard]] std::string relative_text(double fraction, int digits = 2);

/// A unit for display: displayed number = SI number * per_si.
struct DisplayUnit {
    double per_si = 1.0;
    std::string name; ///< "mPa s"; empty for pure numbers
};

/// The unit with the SI prefix that suits numbers up to `largest` (SI, sign ignored). Only Pa, N,
/// m, s and what starts with them take a prefix; rates and angles stay as they are; lengths stay in
/// mm from 0.1 mm up to 1 m. `si_unit` is written as in case files: "Pa.s", "N m", "1/s", "1".
[[nodiscard]] DisplayUnit display_unit(std::string_view si_unit, double largest);

/// "1.0016 mPa s".
[[nodiscard]] std::string quantity_text(double value, std::string_view si_unit, int digits = 6);

} // namespace searle::rheometry::report
