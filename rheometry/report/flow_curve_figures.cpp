#include "rheometry/report/flow_curve_figures.hpp"

#include "rheometry/report/deviation.hpp"
#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/regime_shading.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace searle::rheometry::report {

namespace {

constexpr std::string_view rate_symbol = "<i>\u03b3\u0307</i>";

RateRange all_rates(const ReportInput& input) {
    RateRange range = rate_range(input.rheogram);
    const auto include = [&](double rate) {
        if (!std::isfinite(rate)) {
            return;
        }
        range.lowest = std::fmin(range.lowest, rate);
        range.highest = std::fmax(range.highest, rate);
        if (rate > 0.0) {
            range.lowest_positive = std::fmin(range.lowest_positive, rate);
        }
    };
    for (const MeasuredSeries& measured : input.measured) {
        for (const double rate : measured.shear_rate) {
            include(rate);
        }
    }
    return range;
}

// Whether the inertia-free curve is another than the flow law's, and than the computed one.
bool inertia_free_differs(const ReportInput& input) {
    constexpr double visible = 5e-3;
    const auto differs = [](double stress, double other) {
        const double share = stress / other - 1.0;
        return std::isfinite(share) && std::abs(share) > visible;
    };
    const auto& points = input.rheogram.points;
    const bool from_computed =
        std::any_of(points.begin(), points.end(), [&](const RheogramPoint& point) {
            return differs(point.shear_stress, point.steady_stress);
        });
    const StressOfRate& law = input.fluid.true_stress;
    return from_computed &&
           (!law || std::any_of(points.begin(), points.end(), [&](const RheogramPoint& point) {
               return differs(std::abs(point.steady_stress), law(std::abs(point.shear_rate)));
           }));
}

void add_flow_curves(Plot& plot, const ReportInput& input, const CurveView& view) {
    const RateRange range = all_rates(input);
    const Scale rate_scale = plot.x.scale;
    const double lowest = rate_scale == Scale::logarithmic ? range.lowest_positive : range.lowest;
    for (Series& series : computed_series(input.rheogram, input.conversion, view, input.transient,
                                          RichText{"virtual instrument"}, 0)) {
        plot.series.push_back(std::move(series));
    }
    if (input.fluid.true_stress) {
        plot.series.push_back(
            law_series(input.fluid.true_stress, lowest, range.highest, view, rate_scale));
    }
    if (input.transient && inertia_free_differs(input)) {
        plot.series.push_back(inertia_free_series(input.rheogram, input.conversion, view));
    }
    int index = 0;
    for (const MeasuredSeries& measured : input.measured) {
        plot.series.push_back(measured_series(measured, view, index++));
    }
    int colour = 2;
    for (const NamedRheogram& other : input.compared_with) {
        for (Series& series : computed_series(other.rheogram, input.conversion, view,
                                              input.transient, RichText{other.name}, colour)) {
            series.marker = series.marker == Marker::none ? Marker::none : Marker::square;
            plot.series.push_back(std::move(series));
        }
        ++colour;
    }
    add_regimes(plot, input.rheogram, view, input.transient);
}

std::string error_bar_sentence(const ReportInput& input, double longest_bar) {
    double largest = -1.0;
    double at_rate = 0.0;
    for (const RheogramPoint& point : input.rheogram.points) {
        const double error = relative_error(point);
        if (std::isfinite(error) && error > largest) {
            largest = error;
            at_rate = point.shear_rate;
        }
    }
    if (largest < 0.0) {
        return "";
    }
    if (largest == 0.0) {
        return " The solver estimates no numerical error.";
    }
    std::string out = " Error bars: the solver\u2019s estimate of its own numerical error";
    if (longest_bar < marker_radius) {
        out += ", everywhere smaller than the symbols";
    }
    return out + " (largest: " + relative_text(largest) + " of the stress, at " +
           std::string{rate_symbol} + " = " + quantity_text(at_rate, "1/s", 4) + ").";
}

std::string loop_sentence(const ReportInput& input) {
    if (!input.transient || !passes_rates_twice(input.rheogram)) {
        return "";
    }
    return " Arrows give the order in time; regimes are shaded over time, in the figure of the "
           "torque, because a rate is passed more than once.";
}

} // namespace

Figure rheogram_figure(const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    const CurveView view =
        view_of(input.rheogram, Quantity::shear_rate, Quantity::shear_stress, rotates);
    FigureBuilder builder;
    const auto add = [&](Scale scale, std::string id) {
        Plot plot;
        plot.id = std::move(id);
        plot.title = "Shear stress over shear rate";
        plot.x = x_axis(view, scale);
        plot.y = y_axis(view, scale);
        add_flow_curves(plot, input, view);
        plot.zero_line = scale == Scale::linear;
        builder.add(std::move(plot));
    };
    add(Scale::linear, "rheogram-linear");
    if (has_positive_pair(input.rheogram, Quantity::shear_rate, Quantity::shear_stress)) {
        add(Scale::logarithmic, "rheogram-log");
    }
    Figure figure = builder.finish("");
    std::string caption =
        "Rheogram: shear stress <i>\u03c4</i> over shear rate " + std::string{rate_symbol};
    if (rotates) {
        caption += " in the convention " + std::string{name_of(input.conversion.definition)};
    }
    caption += figure.panels.size() > 1 ? ", on linear (a) and logarithmic (b) axes." : ".";
    caption += error_bar_sentence(input, builder.longest_error_bar());
    caption += loop_sentence(input);
    figure.caption = caption + figure.caption;
    return figure;
}

Figure viscosity_figure(const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    const CurveView view =
        view_of(input.rheogram, Quantity::shear_rate, Quantity::viscosity, rotates);
    Plot plot;
    plot.id = "viscosity";
    plot.title = "Viscosity over shear rate";
    const bool positive =
        has_positive_pair(input.rheogram, Quantity::shear_rate, Quantity::viscosity);
    plot.x = x_axis(view, positive ? Scale::logarithmic : Scale::linear);
    plot.y = y_axis(view, positive ? Scale::logarithmic : Scale::linear);
    add_flow_curves(plot, input, view);
    FigureBuilder builder;
    builder.add(std::move(plot));
    std::string caption =
        "Viscosity curve, <i>\u03b7</i> = <i>\u03c4</i>/" + std::string{rate_symbol} + ".";
    if (deviation_matters(input)) {
        builder.add(deviation_plot(input, view));
        const Deviation deviation = largest_deviation(input.rheogram, input.fluid.true_stress);
        caption = "(a) " + caption +
                  " (b) Deviation of the apparent viscosity from the flow law; largest " +
                  relative_text(deviation.largest, 3) + " at " + std::string{rate_symbol} + " = " +
                  quantity_text(deviation.at_rate, "1/s", 4) + ".";
        const DeviationParts parts = deviation_parts(input);
        const auto& points = input.rheogram.points;
        const bool has_vortices =
            std::any_of(points.begin(), points.end(), [](const RheogramPoint& point) {
                return point.regime.find("taylor-vortices") != std::string::npos;
            });
        const std::string inertia = std::string{"the inertia of the fluid"} +
                                    (has_vortices ? ", vortices included" : "") +
                                    ", <i>\u03c4</i>/<i>\u03c4</i><sub>steady</sub> \u2212 1";
        const std::string convention =
            "the convention, which reads one rate and one stress from a gap that has many";
        if (parts.particles) {
            caption += " It comes from the stress of the particles";
            caption +=
                parts.inertia ? " and, what the wall shows beyond the bulk, from inertia." : ".";
        } else if (parts.inertia && parts.convention) {
            caption += " It has two parts: " + inertia + ", and " + convention + ".";
        } else if (parts.inertia || parts.convention) {
            caption += " It comes from " + (parts.inertia ? inertia : convention) + ".";
        }
    }
    return builder.finish(std::move(caption));
}

} // namespace searle::rheometry::report
