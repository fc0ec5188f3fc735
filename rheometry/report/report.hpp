#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>

namespace searle::rheometry::report {

/// The page report.html: complete HTML in UTF-8 that needs no network.
/// Any data is accepted; values that a figure cannot show are left out of it, and it says so.
/// Stays below 2 MB: from a few thousand rows on, figures and table show a thinned choice.
[[nodiscard]] std::string render_report(const ReportInput& input);

/// The page over a sweep: all runs in one pair of figures, and a table that links their reports.
[[nodiscard]] std::string render_overlay(const OverlayInput& input);

} // namespace searle::rheometry::report
