#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// A row of a table of properties; all three are HTML.
struct PropertyRow {
    std::string name;
    std::string symbol;
    std::string value;
};

/// Lengths as the case gives them, with their lines, and what follows from them.
[[nodiscard]] std::vector<PropertyRow> instrument_rows(const ReportInput& input);

/// The flow law's formula and parameters, and the density.
[[nodiscard]] std::vector<PropertyRow> fluid_rows(const ReportInput& input);

/// The convention, its formulas spelled out, and its factors.
[[nodiscard]] std::vector<PropertyRow> conversion_rows(const ReportInput& input);

/// Whether each row's stress was converted with the end factor computed for its speed.
[[nodiscard]] bool has_computed_end_factors(const ReportInput& input);

/// The end factors that were computed and used, smallest to largest, e.g. "1.2564 – 1.2599"; of
/// rows whose secondary flow was solved with it.
[[nodiscard]] std::string computed_end_factors(const ReportInput& input);

/// Engine, model, accuracy asked and estimated, times by stage, further facts.
[[nodiscard]] std::vector<PropertyRow> solution_rows(const ReportInput& input);

/// A table of properties with a caption (HTML).
[[nodiscard]] std::string property_table(const std::vector<PropertyRow>& rows,
                                         const std::string& caption);

/// " (line 7)" for a key that stands in the case file, else nothing. HTML.
[[nodiscard]] std::string source_note(const ReportInput& input, std::string_view key);

/// "single gap", "DIN bob": an instrument's name in running text.
[[nodiscard]] std::string_view instrument_phrase(const ReportInput& input);

/// "Herschel–Bulkley fluid" for "herschel-bulkley".
[[nodiscard]] std::string fluid_phrase(std::string_view model);

} // namespace searle::rheometry::report
