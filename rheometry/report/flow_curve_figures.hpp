#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

#include <vector>

namespace searle::rheometry::report {

/// Stress over rate, on linear and on logarithmic axes.
[[nodiscard]] Figure rheogram_figure(const ReportInput& input);

/// Viscosity over rate with the law's viscosity, and its deviation where that matters.
[[nodiscard]] Figure viscosity_figure(const ReportInput& input);

/// The torque (the box: force) over time with its inertia-free course; for steady series over speed.
[[nodiscard]] Figure torque_figure(const ReportInput& input);

/// The estimated relative error of every point beside the accuracy asked for.
[[nodiscard]] Figure error_figure(const ReportInput& input);

/// Largest |viscosity / law's viscosity - 1| over the points with a viscosity; NaN without a law.
struct Deviation {
    double largest{};
    double at_rate{};
};
[[nodiscard]] Deviation largest_deviation(const ReportInput& input);

} // namespace searle::rheometry::report
