#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

#include <vector>

namespace searle::rheometry::report {

/// Figures of the flow at some of the rows with fields: in an endless gap the velocity and the rate
/// of shear across it, else the rate of shear on the section with the yield surface, and where
/// there is one the stream function of the secondary flow. Empty without fields.
[[nodiscard]] std::vector<Figure> field_figures(const ReportInput& input);

} // namespace searle::rheometry::report
