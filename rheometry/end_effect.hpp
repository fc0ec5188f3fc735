#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace searle::rheometry {

/// c_L of the creeping flow at one speed: the torque of the whole instrument over that of the same
/// length of an endless one.
struct EndEffect {
    double speed{};      ///< rad/s
    double shear_rate{}; ///< 1/s, at the conversion's definition
    /// c_L of the creeping flow; of an engine that solves the whole flow alone as `with_inertia`.
    double end_factor{};
    double error{}; ///< estimate of its numerical error, absolute
    /// Bounds of c_L from the energies, nan where it was interpolated between other speeds.
    double lower{};
    double upper{};
    /// c_L of the steady flow with inertia, i.e. secondary flow included, and its error; nan where
    /// that was not solved for.
    double with_inertia = std::numeric_limits<double>::quiet_NaN();
    double with_inertia_error = std::numeric_limits<double>::quiet_NaN();
};

/// Columns: angular_velocity_rad_s, shear_rate_1_s, end_factor, end_factor_error,
/// end_factor_lower_bound, end_factor_upper_bound, end_factor_with_inertia,
/// end_factor_with_inertia_error; 17 significant digits.
[[nodiscard]] std::string end_effect_csv(const std::vector<EndEffect>& rows);

/// Reads what end_effect_csv wrote. Throws TableError.
[[nodiscard]] std::vector<EndEffect> read_end_effect_csv(const std::filesystem::path& file);

} // namespace searle::rheometry
