#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>

namespace searle::rheometry::report {

/// What was solved, what was left out and why, with the numbers that decided. HTML; empty when
/// there is nothing to say.
[[nodiscard]] std::string validity_section(const ReportInput& input, int table_number);

/// True when the section has something to say.
[[nodiscard]] bool has_validity(const ReportInput& input);

} // namespace searle::rheometry::report
