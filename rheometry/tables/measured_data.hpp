#pragma once

#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/spreadsheet.hpp"
#include "rheometry/tables/table_error.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace searle::rheometry {

/// A series of measured rows in SI units; the columns have the same length, or are empty where the
/// file has none.
struct MeasuredStep {
    std::string name;                 ///< "Flow sweep - 3"; empty for a plain table
    std::vector<double> time;         ///< s, as in the file; may be empty
    std::vector<double> speed;        ///< rad/s (m/s for the box)
    std::vector<double> torque;       ///< N m (N for the box)
    std::vector<std::size_t> lines;   ///< of the file (of the sheet) that the rows stand in
    std::vector<std::string> regimes; ///< of a rheogram: "laminar", "lag"; empty: not known
    /// Whether the rows are points of a flow curve; a speed that had to be derived from the
    /// displacement belongs to a start-up at one speed.
    bool is_flow_curve = true;
    /// What the instrument's own software made of it, where the file says: 1/s and Pa.
    std::vector<double> exported_rate;
    std::vector<double> exported_stress;
};

/// What an export says about the geometry it was measured with, SI units.
struct ExportedGeometry {
    std::string name;
    std::optional<double> bob_radius;
    std::optional<double> cup_radius;
    std::optional<double> bob_length;
    std::optional<double> end_factor;
    std::optional<double> stress_constant; ///< Pa per N m
    std::optional<double> strain_constant; ///< 1/s per rad/s
};

struct MeasuredData {
    std::vector<MeasuredStep> steps;
    ExportedGeometry geometry;
    /// Sentences for the user: steps left out and why, speeds that had to be derived.
    std::vector<std::string> remarks;
};

/// What the drive of the instrument does.
enum class DriveMotion { turning, sliding };

/// A table with a speed and a torque (of a sliding drive: a wall speed and a force), and a time if
/// there is one; column_names.hpp has the accepted headings. Throws TableError.
[[nodiscard]] MeasuredData measured_from_table(const CsvTable& table, DriveMotion motion);

/// True when the sheets are laid out as TRIOS (TA Instruments) does it: a sheet "Details", and a
/// sheet per step with its name, headings, units and rows.
[[nodiscard]] bool is_trios_layout(std::span<const Sheet> sheets);

/// The steps of an export of TRIOS. Steps without a torque and a speed, as in oscillation, are left
/// out with a remark. A step that gives no velocity gets it from the shear rate and the strain
/// constant of the details, or else from the displacement. Throws TableError, also when no step is
/// left.
/// @param file  name for messages
[[nodiscard]] MeasuredData measured_from_trios(std::span<const Sheet> sheets,
                                               const std::string& file);

/// Sheets of a workbook or of an export of TRIOS in JSON; empty for text. Throws TableError.
[[nodiscard]] std::vector<Sheet> sheets_of(const std::filesystem::path& file);

/// Reads a file of raw data: delimited text (csv_table.hpp), a workbook (.xls, .xlsx) that TRIOS
/// exported or whose sheets hold such tables, or an export of TRIOS in JSON. What it is, the file's
/// first bytes tell. Throws TableError.
[[nodiscard]] MeasuredData read_measured_data(const std::filesystem::path& file,
                                              DriveMotion motion);

} // namespace searle::rheometry
