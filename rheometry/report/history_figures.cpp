#include "rheometry/report/history_figures.hpp"

#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace searle::rheometry::report {

namespace {

// Whether the speed grows linearly over the rows, so that its course needs no figure.
bool is_one_ramp(const Rheogram& rheogram) {
    const auto& points = rheogram.points;
    if (points.size() < 3) {
        return true;
    }
    const RheogramPoint& first = points.front();
    const RheogramPoint& last = points.back();
    const double slope = (last.speed - first.speed) / (last.time - first.time);
    const double tolerance = 1e-6 * largest_value(rheogram, Quantity::drive_speed);
    return std::all_of(points.begin(), points.end(), [&](const RheogramPoint& point) {
        const double expected = first.speed + slope * (point.time - first.time);
        return std::abs(point.speed - expected) <= tolerance;
    });
}

} // namespace

Figure torque_figure(const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    const QuantityLook response = look_of(Quantity::torque, rotates);
    const Quantity x = input.transient ? Quantity::time : Quantity::drive_speed;
    const CurveView view = view_of(input.rheogram, x, Quantity::torque, rotates);
    Scale scale = Scale::linear;
    if (!input.transient) {
        const bool spread = suitable_scale(column(input.rheogram, x)) == Scale::logarithmic &&
                            has_positive_pair(input.rheogram, x, Quantity::torque);
        scale = spread ? Scale::logarithmic : Scale::linear;
    }
    Plot plot;
    plot.id = "torque";
    plot.title = response.name + (input.transient ? " over time" : " over speed");
    plot.x = x_axis(view, scale);
    plot.y = y_axis(view, scale);
    plot.zero_line = scale == Scale::linear;
    for (Series& series : computed_series(input.rheogram, input.conversion, view, input.transient,
                                          RichText{"virtual instrument"}, 0)) {
        plot.series.push_back(std::move(series));
    }
    if (input.transient) {
        plot.series.push_back(inertia_free_series(input.rheogram, input.conversion, view));
    }
    add_regimes(plot, input.rheogram, view, input.transient);
    FigureBuilder builder;
    builder.add(std::move(plot));
    const std::string whole =
        rotates              ? "Torque on the rotor of the whole instrument (360\u00b0), "
        : is_periodic(input) ? "Shear stress of the bulk times the area of the box\u2019s top, "
                             : "Force on the whole moving wall, ";
    if (!input.transient) {
        return builder.finish(whole + "over the speed of the drive; steady flow.");
    }

    std::string caption = whole + "over time. Dashed: " +
                          (input.particles ? "the steady flow of the fluid alone "
                                           : "without inertia, the torque of the steady flow ") +
                          "at the speed of the moment.";
    if (!is_one_ramp(input.rheogram)) {
        const CurveView drive = view_of(input.rheogram, x, Quantity::shear_rate, rotates);
        Plot program;
        program.id = "program";
        program.title = "Shear rate over time";
        program.x = x_axis(drive, Scale::linear);
        program.y = y_axis(drive, Scale::linear);
        program.zero_line = true;
        program.series =
            computed_series(input.rheogram, input.conversion, drive, true, RichText{}, 0);
        for (Series& series : program.series) {
            series.error.clear();
        }
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
    }
    estimated.tip = [&points = input.rheogram.points](std::size_t k) {
        return "\u03b3\u0307 = " + quantity_text(points[k].shear_rate, "1/s", 4) +
               "\nestimated relative error " + relative_text(relative_error(points[k]));
    };
    Plot plot;
    plot.id = "error";
    plot.title = "Relative numerical error of each point";
    plot.x.name = over_time ? axis_name(look_of(Quantity::time, true), second) : RichText{"Point"};
    plot.y.name = RichText{"Relative error of "}.italic("\u03c4");
    plot.y.scale = Scale::logarithmic;
    plot.series.push_back(estimated);
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
    FigureBuilder builder;
    builder.add(std::move(plot));
    return builder.finish(
        "Numerical error of the shear stress, relative, as the solver estimates it, "
        "point by point, beside the accuracy that the case asks for.");
}

} // namespace searle::rheometry::report
