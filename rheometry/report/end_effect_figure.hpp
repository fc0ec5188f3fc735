#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

namespace searle::rheometry::report {

/// End factor c_L over the shear rate with error bars, beside the factor that the conversion uses.
/// `input.ends` is not empty.
[[nodiscard]] Figure end_effect_figure(const ReportInput& input);

} // namespace searle::rheometry::report
