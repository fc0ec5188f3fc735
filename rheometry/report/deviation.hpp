#pragma once

#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/report_input.hpp"

namespace searle::rheometry::report {

/// Largest |viscosity / law's viscosity - 1| over the points, and its rate in 1/s.
struct Deviation {
    double largest{}; ///< NaN where no point has both viscosities
    double at_rate{};
};
[[nodiscard]] Deviation largest_deviation(const Rheogram& rheogram, const StressOfRate& law);

/// Which parts of the deviation can be seen (above 1e-6 somewhere).
struct DeviationParts {
    bool inertia{};
    bool convention{};
    bool particles{};
};
[[nodiscard]] DeviationParts deviation_parts(const ReportInput& input);

/// True when the deviation exceeds the accuracy asked for.
[[nodiscard]] bool deviation_matters(const ReportInput& input);

/// Deviation over rate, with the parts of inertia, convention and particles. The input must have a
/// law and outlive the plot.
[[nodiscard]] Plot deviation_plot(const ReportInput& input, const CurveView& flow_view);

} // namespace searle::rheometry::report
