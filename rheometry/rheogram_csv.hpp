#pragma once

#include "rheometry/rheogram.hpp"
#include "rheometry/tables/table_error.hpp"

#include <filesystem>
#include <ostream>
#include <string>

namespace searle::rheometry {

/// What the first columns after the time are called.
enum class DriveColumns {
    turning, ///< angular_velocity_rad_s,torque_N_m
    sliding  ///< wall_speed_m_s,wall_force_N: the box
};

[[nodiscard]] DriveColumns drive_columns(const geometry::Instrument& instrument);

/// The header line of rheogram.csv without its line end: the names that scripts depend on, then
/// steady_stress_Pa,bob_shear_rate_1_s,yield_radius_m, and for a suspension the parts of its
/// stress.
[[nodiscard]] std::string rheogram_header(DriveColumns columns, bool suspension = false);

/// Writes rheogram.csv: header, a row per point, 17 significant digits, `nan` where there is no
/// value, lines ending in \n.
void write_rheogram_csv(std::ostream& stream, const Rheogram& rheogram, DriveColumns columns);

/// A rheogram as read back, and which columns its drive had.
struct RheogramFile {
    Rheogram rheogram;
    DriveColumns columns = DriveColumns::turning;
};

/// Reads a rheogram.csv. Required: shear_rate_1_s and shear_stress_Pa, finite numbers; every other
/// column may be absent (NaN; an empty regime), and the viscosity is then stress over rate. Of one
/// drive only: both kinds of columns are an error. Throws TableError.
[[nodiscard]] RheogramFile read_rheogram_csv(const std::filesystem::path& file);

} // namespace searle::rheometry
