#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

#include <vector>

namespace searle::rheometry::report {

/// Stress over rate, on linear and on logarithmic axes.
[[nodiscard]] Figure rheogram_figure(const ReportInput& input);

/// Viscosity over rate with the law's viscosity, and its deviation where that matters.
[[nodiscard]] Figure viscosity_figure(const ReportInput& input);

} // namespace searle::rheometry::report
