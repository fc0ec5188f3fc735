#include "rheometry/report/flow_curve_figures.hpp"

#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/regime_shading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace searle::rheometry::report {

namespace {

constexpr std::string_view rate_symbol = "<i>\u03b3\u0307</i>";

std::vector<double> column(const Rheogram& rheogram, Quantity quantity, double factor = 1.0) {
    std::vector<double> values;
    values.reserve(rheogram.points.size());
    for (const RheogramPoint& point : rheogram.points) {
        values.push_back(value_of(point, quantity) * factor);
    }
    return values;
}

// Regimes over the x axis; over rates only where a rate names one point.
void add_shading(Plot& plot, const ReportInput& input, const CurveView& view) {
    if (view.x != Quantity::time && input.transient && passes_rates_twice(input.rheogram)) { return; }
    const std::vector<double> x = column(input.rheogram, view.x, view.x_unit.per_si);
    RegimeShading shading = shade_regimes(input.rheogram.points, x);
    plot.bands = std::move(shading.bands);
    plot.band_kinds = std::move(shading.kinds);
}

RateRange all_rates(const ReportInput& input) {
    RateRange range = rate_range(input.rheogram);
    const auto include = [&](double rate) {
        if (!std::isfinite(rate)) { return; }
        range.lowest = std::fmin(range.lowest, rate);
        range.highest = std::fmax(range.highest, rate);
        if (rate > 0.0) { range.lowest_positive = std::fmin(range.lowest_positive, rate); }
    };
    for (const MeasuredSeries& measured : input.measured) {
        for (const double rate : measured.shear_rate) { include(rate); }
    }
    return range;
}

bool inertia_shows(const ReportInput& input) {
    return std::any_of(input.rheogram.points.begin(), input.rheogram.points.end(),
                       [](const RheogramPoint& point) {
                           const double share = point.shear_stress / point.steady_stress - 1.0;
                           return std::isfinite(share) && std::abs(share) > 5e-3;
                       });
}

void add_flow_curves(Plot& plot, const ReportInput& input, const CurveView& view) {
    const RateRange range = all_rates(input);
    const Scale rate_scale = plot.x.scale;
    const double lowest =
        rate_scale == Scale::logarithmic ? range.lowest_positive : range.lowest;
    if (input.fluid.true_stress) {
        plot.series.push_back(
            law_series(input.fluid.true_stress, lowest, range.highest, view, rate_scale));
    }
    if (input.transient && inertia_shows(input)) {
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
    for (Series& series : computed_series(input.rheogram, input.conversion, view, input.transient,
                                          RichText{"virtual instrument"}, 0)) {
        plot.series.push_back(std::move(series));
    }
    add_shading(plot, input, view);
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
    if (largest < 0.0) { return ""; }
    if (largest == 0.0) { return " The solver estimates no numerical error."; }
    std::string out = " Error bars: the solver\u2019s estimate of its own numerical error";
    if (longest_bar < marker_radius) { out += ", everywhere smaller than the symbols"; }
    return out + " (largest: " + relative_text(largest) + " of the stress, at " +
           std::string{rate_symbol} + " = " + quantity_text(at_rate, "1/s", 4) + ").";
}

std::string loop_sentence(const ReportInput& input) {
    if (!input.transient || !passes_rates_twice(input.rheogram)) { return ""; }
    return " Arrows give the order in time; regimes are shaded over time, in the figure of the "
           "torque, because a rate is passed more than once.";
}

bool has_positive_pair(const Rheogram& rheogram, Quantity x, Quantity y) {
    return std::any_of(rheogram.points.begin(), rheogram.points.end(),
                       [&](const RheogramPoint& point) {
                           const double first = value_of(point, x);
                           const double second = value_of(point, y);
                           return first > 0.0 && second > 0.0 && std::isfinite(first) &&
                                  std::isfinite(second);
                       });
}

struct DeviationPoint {
    double total{};
    double inertia{};
    double definition{};
};

DeviationPoint deviation_of(const RheogramPoint& point, const StressOfRate& law) {
    const double rate = point.shear_rate;
    const double true_stress = std::copysign(law(std::abs(rate)), rate);
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    if (rate == 0.0 || true_stress == 0.0) { return {undefined, undefined, undefined}; }
    return {point.shear_stress / true_stress - 1.0,
            point.shear_stress / point.steady_stress - 1.0,
            point.steady_stress / true_stress - 1.0};
}

bool deviation_matters(const ReportInput& input) {
    const double largest = largest_deviation(input).largest;
    return largest > std::max(input.accuracy, 1e-6);
}

Plot deviation_plot(const ReportInput& input, const CurveView& flow_view) {
    constexpr double percent = 100.0;
    Plot plot;
    plot.id = "deviation";
    plot.title = "Deviation of the apparent viscosity from the law's";
    Series total;
    total.name = RichText{"apparent viscosity"};
    total.marker = Marker::circle;
    Series inertia;
    inertia.name = RichText{"part of inertia"};
    inertia.colour = 1;
    inertia.stroke = Stroke::dashed;
    Series definition;
    definition.name = RichText{"part of the convention"};
    definition.colour = 2;
    definition.stroke = Stroke::dotted;
    double largest_inertia = 0.0;
    double largest_definition = 0.0;
    for (const RheogramPoint& point : input.rheogram.points) {
        const DeviationPoint deviation = deviation_of(point, input.fluid.true_stress);
        const double rate = point.shear_rate * flow_view.x_unit.per_si;
        total.x.push_back(rate);
        total.y.push_back(percent * deviation.total);
        total.error.push_back(percent * std::abs(point.stress_error / point.shear_stress) *
                              (1.0 + deviation.total));
        total.tips.push_back("\u03b3\u0307 = " + quantity_text(point.shear_rate, "1/s", 4) +
                             "\n\u03b7/\u03b7_law \u2212 1 = " + relative_text(deviation.total, 4));
        inertia.x.push_back(rate);
        inertia.y.push_back(percent * deviation.inertia);
        definition.x.push_back(rate);
        definition.y.push_back(percent * deviation.definition);
        if (std::isfinite(deviation.inertia)) {
            largest_inertia = std::max(largest_inertia, std::abs(deviation.inertia));
        }
        if (std::isfinite(deviation.definition)) {
            largest_definition = std::max(largest_definition, std::abs(deviation.definition));
        }
    }
    Axis rates = x_axis(flow_view, suitable_scale(total.x));
    if (!has_positive_pair(input.rheogram, Quantity::shear_rate, Quantity::shear_rate)) {
        rates.scale = Scale::linear;
    }
    plot.x = rates;
    plot.y.scale = suitable_scale(total.y);
    plot.y.name.italic("\u03b7").upright("/").italic("\u03b7").subscript("law").upright(" \u2212 1 (%)");
    plot.zero_line = plot.y.scale == Scale::linear;
    const bool loop = passes_rates_twice(input.rheogram);
    if (loop && input.transient) {
        total.stroke = Stroke::solid;
        total.thin = true;
        total.shows_direction = true;
    }
    if (largest_inertia > 1e-6 && input.transient) { plot.series.push_back(std::move(inertia)); }
    if (largest_definition > 1e-6) { plot.series.push_back(std::move(definition)); }
    plot.series.push_back(std::move(total));
    return plot;
}

} // namespace

Deviation largest_deviation(const ReportInput& input) {
    Deviation out{std::numeric_limits<double>::quiet_NaN(), 0.0};
    if (!input.fluid.true_stress) { return out; }
    for (const RheogramPoint& point : input.rheogram.points) {
        const double total = std::abs(deviation_of(point, input.fluid.true_stress).total);
        if (!std::isfinite(total) || total <= out.largest) { continue; }
        out = {total, point.shear_rate};
    }
    return out;
}

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
    std::string caption = "Rheogram: shear stress <i>\u03c4</i> over shear rate " +
                          std::string{rate_symbol} + " in the convention " +
                          std::string{name_of(input.conversion.definition)};
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
    std::string caption = "Viscosity curve, <i>\u03b7</i> = <i>\u03c4</i>/" +
                          std::string{rate_symbol} + ".";
    if (deviation_matters(input)) {
        builder.add(deviation_plot(input, view));
        const Deviation deviation = largest_deviation(input);
        caption = "(a) " + caption +
                  " (b) Deviation of the apparent viscosity from the flow law; largest " +
                  relative_text(deviation.largest, 3) + " at " + std::string{rate_symbol} + " = " +
                  quantity_text(deviation.at_rate, "1/s", 4) + ".";
        caption += input.transient
                       ? " It has two parts: the inertia of the fluid, <i>\u03c4</i>/<i>\u03c4</i>"
                         "<sub>steady</sub> \u2212 1, and the convention, which reads one rate and "
                         "one stress from a gap that has many."
                       : " The flow is steady, so it comes from the convention, which reads one "
                         "rate and one stress from a gap that has many.";
    }
    return builder.finish(std::move(caption));
}

Figure torque_figure(const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    const QuantityLook response = look_of(Quantity::torque, rotates);
    const Quantity x = input.transient ? Quantity::time : Quantity::drive_speed;
    const CurveView view = view_of(input.rheogram, x, Quantity::torque, rotates);
    Scale scale = Scale::linear;
    if (!input.transient) {
        const bool spread =
            suitable_scale(column(input.rheogram, x)) == Scale::logarithmic &&
            has_positive_pair(input.rheogram, x, Quantity::torque);
        scale = spread ? Scale::logarithmic : Scale::linear;
    }
    Plot plot;
    plot.id = "torque";
    plot.title = response.name + (input.transient ? " over time" : " over speed");
    plot.x = x_axis(view, scale);
    plot.y = y_axis(view, scale);
    plot.zero_line = scale == Scale::linear;
    if (input.transient) {
        plot.series.push_back(inertia_free_series(input.rheogram, input.conversion, view));
    }
    for (Series& series : computed_series(input.rheogram, input.conversion, view, input.transient,
                                          RichText{"virtual instrument"}, 0)) {
        plot.series.push_back(std::move(series));
    }
    add_shading(plot, input, view);
    FigureBuilder builder;
    builder.add(std::move(plot));
    const std::string whole = rotates ? "Torque on the rotor of the whole instrument (360\u00b0), "
                                      : "Force on the whole moving wall, ";
    if (!input.transient) { return builder.finish(whole + "over the speed of the drive; steady flow."); }

    const std::vector<double> speeds = column(input.rheogram, Quantity::drive_speed);
    const std::vector<double> times = column(input.rheogram, Quantity::time);
    bool straight = true;
    for (std::size_t k = 2; k < speeds.size(); ++k) {
        const double expected = speeds[1] + (speeds[k] - speeds[0]) / (times[k] - times[0]) *
                                                (times[1] - times[0]) - (speeds[1] - speeds[0]);
        straight = straight && std::abs(expected - speeds[1]) <= 1e-6 * std::abs(speeds[k]);
    }
    std::string caption = whole + "over time. Dashed: without inertia, the torque of the steady flow "
                                  "at the speed of the moment.";
    if (!straight) {
        const CurveView drive = view_of(input.rheogram, x, Quantity::shear_rate, rotates);
        Plot program;
        program.id = "program";
        program.title = "Shear rate over time";
        program.x = x_axis(drive, Scale::linear);
        program.y = y_axis(drive, Scale::linear);
        program.zero_line = true;
        program.series = computed_series(input.rheogram, input.conversion, drive, true, RichText{}, 0);
        for (Series& series : program.series) { series.error.clear(); }
        builder.add(std::move(program));
        caption = "(a) " + caption + " (b) The shear rate that the drive imposes.";
    }
    return builder.finish(std::move(caption));
}

Figure error_figure(const ReportInput& input) {
    const bool over_time = input.transient;
    Series estimated;
    estimated.name = RichText{"estimated"};
    estimated.marker = Marker::circle;
    const DisplayUnit second = display_unit("s", largest_value(input.rheogram, Quantity::time));
    double number = 0.0;
    for (const RheogramPoint& point : input.rheogram.points) {
        number += 1.0;
        estimated.x.push_back(over_time ? point.time * second.per_si : number);
        estimated.y.push_back(relative_error(point));
        estimated.tips.push_back("\u03b3\u0307 = " + quantity_text(point.shear_rate, "1/s", 4) +
                                 "\nestimated relative error " + relative_text(relative_error(point)));
    }
    Plot plot;
    plot.id = "error";
    plot.title = "Relative numerical error of each point";
    plot.x.name = over_time ? axis_name(look_of(Quantity::time, true), second)
                            : RichText{"Point"};
    plot.y.name = RichText{"Relative error of "}.italic("\u03c4");
    plot.y.scale = Scale::logarithmic;
    if (input.accuracy > 0.0 && !estimated.x.empty()) {
        Series asked;
        asked.name = RichText{"asked for"};
        asked.colour = 1;
        asked.stroke = Stroke::dashed;
        const auto [low, high] = std::minmax_element(estimated.x.begin(), estimated.x.end());
        asked.x = {*low, *high};
        asked.y = {input.accuracy, input.accuracy};
        plot.series.push_back(std::move(asked));
    }
    plot.series.push_back(std::move(estimated));
    FigureBuilder builder;
    builder.add(std::move(plot));
    return builder.finish("Numerical error of the shear stress, relative, as the solver estimates it, "
                          "point by point, beside the accuracy that the case asks for.");
}

} // namespace searle::rheometry::report
