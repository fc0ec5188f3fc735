#pragma once

#include "rheometry/report/plot.hpp"
#include "rheometry/report/quantity.hpp"
#include "rheometry/report/report_input.hpp"

#include <vector>

namespace searle::rheometry::report {

/// Which columns a plot shows, and in which units.
struct CurveView {
    Quantity x{};
    Quantity y{};
    DisplayUnit x_unit;
    DisplayUnit y_unit;
    bool rotates = true;
};

/// The view of two columns of a rheogram in units that suit its numbers.
[[nodiscard]] CurveView view_of(const Rheogram& rheogram, Quantity x, Quantity y, bool rotates);

/// Axes with the names of the view's quantities.
[[nodiscard]] Axis x_axis(const CurveView& view, Scale scale);
[[nodiscard]] Axis y_axis(const CurveView& view, Scale scale);

/// The computed points with error bars and tooltips; refers to the rheogram while it lives. A
/// history whose rates rise and fall is drawn in its order, with arrows, rising rates filled and
/// falling ones open.
[[nodiscard]] std::vector<Series> computed_series(const Rheogram& rheogram,
                                                  const Conversion& conversion,
                                                  const CurveView& view, bool transient,
                                                  const RichText& name, int colour);

/// The law itself over the rates of the rheogram, for a view of stress or viscosity over rate;
/// odd in the rate, with a hole at the jump of a yield stress.
[[nodiscard]] Series law_series(const StressOfRate& law, double lowest_rate, double highest_rate,
                                const CurveView& view, Scale rate_scale);

/// The inertia-free stress, viscosity or torque of the points, as a line over the view's x.
[[nodiscard]] Series inertia_free_series(const Rheogram& rheogram, const Conversion& conversion,
                                         const CurveView& view);

/// Measured points as stress or viscosity over rate; refers to `measured` while it lives.
[[nodiscard]] Series measured_series(const MeasuredSeries& measured, const CurveView& view,
                                     int index);

/// Finite rates of a rheogram: lowest, highest, lowest positive (NaN when there are none).
struct RateRange {
    double lowest{};
    double highest{};
    double lowest_positive{};
};
[[nodiscard]] RateRange rate_range(const Rheogram& rheogram);

/// Logarithmic when all finite values are positive and spread over more than a factor 30.
[[nodiscard]] Scale suitable_scale(const std::vector<double>& values);

/// A column of the rheogram times a factor.
[[nodiscard]] std::vector<double> column(const Rheogram& rheogram, Quantity quantity,
                                         double factor = 1.0);

/// True when some point has both quantities finite and positive, as logarithmic axes need.
[[nodiscard]] bool has_positive_pair(const Rheogram& rheogram, Quantity x, Quantity y);

/// Shades the regimes over the plot's x axis; over rates or speeds only where each is passed once.
void add_regimes(Plot& plot, const Rheogram& rheogram, const CurveView& view, bool transient);

} // namespace searle::rheometry::report
