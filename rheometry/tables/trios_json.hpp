#pragma once

#include "rheometry/tables/spreadsheet.hpp"

#include <filesystem>
#include <vector>

namespace searle::rheometry {

/// Reads a JSON file that TRIOS (TA Instruments) exported
/// (https://software.tainstruments.com/schemas/TRIOSJSONExportSchema) and lays it out as TRIOS lays
/// out its spreadsheets: a sheet "Details" with the geometry, and a sheet per step with name,
/// headings, units and rows. Of the two sets of results the processed one is taken. TRIOS writes
/// all of its columns in every row: columns without a number in a step are left out, and so are the
/// torque and the velocity of steps in oscillation, which are none of a flow.
/// Throws TableError for a file that is missing, no JSON, or none of TRIOS.
[[nodiscard]] std::vector<Sheet> read_trios_json(const std::filesystem::path& file);

} // namespace searle::rheometry
