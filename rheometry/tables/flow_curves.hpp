#pragma once

#include "rheometry/fit/flow_data.hpp"
#include "rheometry/tables/table_error.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::rheometry {

/// A measured or computed flow curve as a file holds it.
struct FlowCurveTable {
    std::string name; ///< of the curve within the file; of the file when it holds one only
    std::vector<fit::MeasuredPoint> points;
};

struct FlowCurveFile {
    std::vector<FlowCurveTable> curves;
    std::vector<std::string> remarks; ///< sentences for the user: what was left out, and why
};

/// Reads the flow curves of a file. What it takes:
///  - delimited text (csv_table.hpp) with a shear rate and a shear stress, units in the headings or
///    in a line below; a column `regime` is used;
///  - exports that put such tables below lines of other text, several in a file (RheoCompass,
///    TRIOS): a table starts at a line with both headings and ends at an empty line;
///  - blocks of `id<TAB>name<TAB>code`, then rate<TAB>stress (1/s, Pa), then an empty line;
///  - exports of TRIOS as workbooks (.xls, .xlsx) or JSON, with the rate and stress of its own
///    software; other workbooks whose sheets hold tables as above.
/// Numbers that are missing (empty, nan) are kept as NaN, text in their place is an error.
/// Throws TableError.
/// @param deviation_column  heading of the column with each stress's standard deviation, in the
///                          stress's unit
[[nodiscard]] FlowCurveFile
read_flow_curves(const std::filesystem::path& file,
                 const std::optional<std::string>& deviation_column = std::nullopt);

} // namespace searle::rheometry
