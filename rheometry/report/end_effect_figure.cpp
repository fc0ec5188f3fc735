#include "rheometry/report/end_effect_figure.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry::report {

Figure end_effect_figure(const ReportInput& input) {
    // An engine that solves the whole flow has one value a row, the inertia in it.
    const bool is_whole = std::ranges::all_of(
        input.ends, [](const EndEffect& row) { return row.with_inertia == row.end_factor; });
    Series computed;
    computed.name =
        RichText{is_whole ? "computed, with secondary flow" : "computed, creeping flow"};
    computed.marker = Marker::circle;
    for (const EndEffect& row : input.ends) {
        computed.x.push_back(std::abs(row.shear_rate));
        computed.y.push_back(row.end_factor);
        computed.error.push_back(row.error);
    }
    computed.tip = [&ends = input.ends](std::size_t k) {
        std::string text = "\u03b3\u0307 = " + quantity_text(ends[k].shear_rate, "1/s", 4) +
                           "\nc_L = " + rounded_to_error(ends[k].end_factor, ends[k].error);
        if (std::isfinite(ends[k].lower)) {
            text += "\nbetween " + significant(ends[k].lower, 6) + " and " +
                    significant(ends[k].upper, 6);
        }
        return text;
    };
    Series with_inertia;
    with_inertia.name = RichText{"computed, with secondary flow"};
    with_inertia.marker = Marker::circle;
    with_inertia.colour = 2;
    for (const EndEffect& row : input.ends) {
        if (!is_whole && std::isfinite(row.with_inertia)) {
            with_inertia.x.push_back(std::abs(row.shear_rate));
            with_inertia.y.push_back(row.with_inertia);
            with_inertia.error.push_back(row.with_inertia_error);
        }
    }
    const auto [low, high] = std::minmax_element(computed.x.begin(), computed.x.end());
    Series used;
    used.name = RichText{"used for the conversion"};
    used.colour = 1;
    used.stroke = Stroke::dashed;
    used.x = {*low, *high};
    used.y = {input.conversion.end_factor, input.conversion.end_factor};

    Plot plot;
    plot.id = "end-factor";
    plot.title = "End factor over shear rate";
    plot.x.name.upright("Shear rate ").italic("\u03b3\u0307").upright(" (1/s)");
    plot.x.scale = *high > 20.0 * *low ? Scale::logarithmic : Scale::linear;
    plot.y.name.upright("End factor ").italic("c").subscript("L");
    plot.y.reach_for_zero = 0.0;
    plot.series.push_back(std::move(computed));
    if (!with_inertia.x.empty()) {
        plot.series.push_back(std::move(with_inertia));
    }
    if (!input.conversion.end_factor_provisional) {
        plot.series.push_back(std::move(used));
    }
    FigureBuilder builder;
    builder.add(std::move(plot));
    return builder.finish(
        "End factor <i>c</i><sub>L</sub>: the torque of the whole bob over that of the same length "
        "of an endless one, for this fluid in creeping flow and, where it was solved for, with the "
        "steady secondary flow. Numbers and energy "
        "bounds: <code>end_factor.csv</code>.");
}

} // namespace searle::rheometry::report
