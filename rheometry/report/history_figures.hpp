#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

namespace searle::rheometry::report {

/// The torque (the box: force) over time with its inertia-free course; for steady series over
/// speed.
[[nodiscard]] Figure torque_figure(const ReportInput& input);

/// The estimated relative error of every point beside the accuracy asked for.
[[nodiscard]] Figure error_figure(const ReportInput& input);

} // namespace searle::rheometry::report
