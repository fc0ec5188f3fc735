#include "rheometry/report/engine_difference.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_style.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace searle::rheometry::report {
namespace {

/// The first run that has all values of this one but the engine; the run itself where it is that.
const OverlayRun& reference_of(const OverlayInput& input, const OverlayRun& run,
                               std::size_t engine) {
    return *std::ranges::find_if(input.runs, [&](const OverlayRun& other) {
        for (std::size_t key = 0; key < input.swept_keys.size(); ++key)
            if (key != engine && other.swept_values.at(key) != run.swept_values.at(key))
                return false;
        return true;
    });
}

Series difference_of(const OverlayRun& run, const OverlayRun& reference) {
    Series series;
    series.name = RichText{run.name};
    series.marker = Marker::circle;
    series.stroke = Stroke::solid;
    series.thin = true;
    const auto& own = run.rheogram.points;
    const auto& others = reference.rheogram.points;
    for (std::size_t row = 0; row < std::min(own.size(), others.size()); ++row) {
        const double stress = others[row].shear_stress;
        if (stress == 0.0)
            continue;
        series.x.push_back(std::abs(others[row].shear_rate));
        series.y.push_back(100.0 * (own[row].shear_stress / stress - 1.0));
        series.error.push_back(100.0 * (own[row].stress_error + others[row].stress_error) /
                               std::abs(stress));
    }
    series.tip = [x = series.x, y = series.y, error = series.error,
                  name = run.name](std::size_t k) {
        return name + "\n\u03b3\u0307 = " + quantity_text(x[k], "1/s", 4) + "\n" +
               significant(y[k], 3) + " % \u00b1 " + significant(error[k], 2) + " %";
    };
    return series;
}

} // namespace

std::optional<Figure> engine_difference_figure(const OverlayInput& input) {
    const auto found = std::ranges::find(input.swept_keys, "solver.engine");
    if (found == input.swept_keys.end())
        return std::nullopt;
    const auto engine = static_cast<std::size_t>(found - input.swept_keys.begin());
    Plot plot;
    plot.id = "engines";
    plot.title = "Difference of the engines over shear rate";
    plot.x.name.upright("Shear rate ").italic("\u03b3\u0307").upright(" (1/s)");
    plot.y.name.upright("Difference in ").italic("\u03c4").upright(" (%)");
    plot.zero_line = true;
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const OverlayRun& run : input.runs) {
        const OverlayRun& reference = reference_of(input, run, engine);
        if (&reference == &run)
            continue;
        Series series = difference_of(run, reference);
        series.colour = static_cast<int>(plot.series.size()) % (series_colour_count - 1) + 1;
        for (const double x : series.x) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
        if (!series.x.empty())
            plot.series.push_back(std::move(series));
    }
    if (plot.series.empty())
        return std::nullopt;
    plot.x.scale = low > 0.0 && high > 20.0 * low ? Scale::logarithmic : Scale::linear;
    FigureBuilder builder;
    builder.add(std::move(plot));
    return builder.finish("Shear stress <i>\u03c4</i> against that of the first engine at the same "
                          "row. Bars: the sum of both engines\u2019 errors; where one reaches zero "
                          "they agree.");
}

} // namespace searle::rheometry::report
