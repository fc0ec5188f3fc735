#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>

namespace searle::rheometry::report {

/// The rheogram as a collapsible table with all digits that the error estimates leave, at most
/// `most_rows` rows (evenly thinned, and it says so), and the link to the CSV. HTML.
[[nodiscard]] std::string data_table(const ReportInput& input, int number,
                                     std::size_t most_rows = 1000);

/// A link that holds the CSV itself; where it would be too long, the file's name.
[[nodiscard]] std::string csv_link(const ReportInput& input);

} // namespace searle::rheometry::report
