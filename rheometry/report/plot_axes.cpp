#include "rheometry/report/plot_axes.hpp"

#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace searle::rheometry::report {

AxisMap::AxisMap(Scale scale, double low, double high) : scale_{scale}, low_{low}, high_{high} {}

void AxisMap::place(double low_pixel, double high_pixel) {
    low_pixel_ = low_pixel;
    high_pixel_ = high_pixel;
}

bool AxisMap::can_show(double value) const {
    return std::isfinite(value) && (scale_ == Scale::linear || value > 0.0);
}

double AxisMap::at(double value) const {
    if (!can_show(value)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double share = scale_ == Scale::linear ? (value - low_) / (high_ - low_)
                                                 : std::log(value / low_) / std::log(high_ / low_);
    return low_pixel_ + share * (high_pixel_ - low_pixel_);
}

TickMarks AxisMap::ticks(int most) const {
    return scale_ == Scale::linear ? linear_ticks(low_, high_, most)
                                   : logarithmic_ticks(low_, high_, most);
}

namespace {

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return low > high; }
};

// Beyond these the differences and ratios of the ends would overflow.
constexpr double largest_drawable = 1e150;
constexpr double smallest_positive = 1e-150;

// A stress that passes through zero leaves a few points decades below all others, which would
// squeeze these into a strip: up to a twentieth of the points are cut off below a jump of a
// factor 30.
std::vector<double> without_stragglers(std::vector<double> values) {
    constexpr double jump = 30.0;
    std::sort(values.begin(), values.end());
    for (std::size_t k = values.size() / 20; k > 0; --k) {
        if (values[k] > jump * values[k - 1]) {
            values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k));
            break;
        }
    }
    return values;
}

Extent data_extent(const Plot& plot, Direction direction) {
    const bool logarithmic =
        (direction == Direction::x ? plot.x : plot.y).scale == Scale::logarithmic;
    const auto can_show = [](const Axis& axis, double value) {
        return std::isfinite(value) && std::abs(value) < largest_drawable &&
               (axis.scale == Scale::linear || value > smallest_positive);
    };
    Extent extent;
    std::vector<double> marked;
    for (const Series& series : plot.series) {
        if (!series.sets_range) {
            continue;
        }
        for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
            if (!can_show(plot.x, series.x[k]) || !can_show(plot.y, series.y[k])) {
                continue;
            }
            const double value = direction == Direction::x ? series.x[k] : series.y[k];
            if (logarithmic && series.marker != Marker::none) {
                marked.push_back(value);
            } else {
                extent.include(value);
            }
            if (direction == Direction::x) {
                continue;
            }
            const double error = k < series.error.size() ? series.error[k] : 0.0;
            if (!std::isfinite(error) || error <= 0.0) {
                continue;
            }
            if (logarithmic) {
                marked.push_back(series.y[k] + error);
            } else {
                extent.include(series.y[k] + error);
            }
            // A bar that reaches zero would stretch a logarithmic axis without end.
            const double lower = series.y[k] - error;
            if (!logarithmic) {
                extent.include(lower);
            } else if (lower > 0.2 * series.y[k]) {
                marked.push_back(lower);
            }
        }
    }
    for (const double value : without_stragglers(std::move(marked))) {
        extent.include(value);
    }
    return extent;
}

void widen_to(Extent& extent, double span) {
    const double centre = 0.5 * (extent.low + extent.high);
    extent.low = std::min(extent.low, centre - 0.5 * span);
    extent.high = std::max(extent.high, centre + 0.5 * span);
}

AxisMap linear_axis(const Axis& axis, Extent extent) {
    if (extent.empty()) {
        extent = {0.0, 1.0};
    }
    const double size = std::max(std::abs(extent.low), std::abs(extent.high));
    if (size < smallest_positive) {
        extent = {0.0, 1.0};
    } else if (extent.high - extent.low < axis.least_relative_span * size) {
        widen_to(extent, axis.least_relative_span * size);
    }
    const double span = extent.high - extent.low;
    const double margin = 0.045 * span;
    double low = extent.low - margin;
    double high = extent.high + margin;
    if (extent.low >= 0.0 && extent.low <= axis.reach_for_zero * span) {
        low = 0.0;
    }
    if (extent.high <= 0.0 && -extent.high <= axis.reach_for_zero * span) {
        high = 0.0;
    }
    low = axis.low.value_or(low);
    high = axis.high.value_or(high);
    return high > low ? AxisMap{axis.scale, low, high} : AxisMap{axis.scale, low, low + 1.0};
}

AxisMap logarithmic_axis(const Axis& axis, Extent extent) {
    if (extent.empty()) {
        extent = {1.0, 10.0};
    }
    const double least_ratio = 1.0 + std::max(axis.least_relative_span, 1e-3);
    if (extent.high / extent.low < least_ratio) {
        const double centre = std::sqrt(extent.low) * std::sqrt(extent.high);
        extent = {centre / std::sqrt(least_ratio), centre * std::sqrt(least_ratio)};
    }
    const double margin = std::pow(extent.high / extent.low, 0.045);
    const double low = axis.low.value_or(extent.low / margin);
    const double high = axis.high.value_or(extent.high * margin);
    const bool usable = low > 0.0 && high > low;
    return usable ? AxisMap{axis.scale, low, high} : AxisMap{axis.scale, 1.0, 10.0};
}

void draw_text(std::string& out, Pixel at, std::string_view anchor, std::string_view css_class,
               const RichText& text, double font) {
    out += "<text";
    if (!css_class.empty()) {
        attribute(out, "class", css_class);
    }
    attribute(out, "x", at.x);
    attribute(out, "y", at.y);
    attribute(out, "text-anchor", anchor);
    out += '>';
    out += text.svg(font);
    out += "</text>";
}

void append_move(std::string& path, Pixel from, Pixel to) {
    const Pixel ends[] = {from, to};
    path += path_through(ends);
}

} // namespace

AxisMap fit_axis(const Plot& plot, Direction direction) {
    const Axis& axis = direction == Direction::x ? plot.x : plot.y;
    const Extent extent = data_extent(plot, direction);
    return axis.scale == Scale::linear ? linear_axis(axis, extent) : logarithmic_axis(axis, extent);
}

void draw_grid(std::string& out, const PlotArea& area, const AxisMap& x, const AxisMap& y,
               const TickMarks& x_ticks, const TickMarks& y_ticks) {
    std::string major;
    for (const Tick& tick : x_ticks.major) {
        const double at = x.at(tick.value);
        append_move(major, {at, area.top}, {at, area.bottom});
    }
    for (const Tick& tick : y_ticks.major) {
        const double at = y.at(tick.value);
        append_move(major, {area.left, at}, {area.right, at});
    }
    out += "<path class=\"grid\" d=\"" + major + "\"/>";
}

void draw_axes(std::string& out, const Plot& plot, const PlotArea& area, const AxisMap& x,
               const AxisMap& y, const TickMarks& x_ticks, const TickMarks& y_ticks) {
    constexpr double major_length = 6.0;
    constexpr double minor_length = 3.0;
    if (plot.zero_line && y.contains(0.0)) {
        draw_line(out, {area.left, y.at(0.0)}, {area.right, y.at(0.0)}, "tick");
    }
    std::string marks;
    for (const Tick& tick : x_ticks.major) {
        const double at = x.at(tick.value);
        append_move(marks, {at, area.bottom}, {at, area.bottom - major_length});
        append_move(marks, {at, area.top}, {at, area.top + major_length});
    }
    for (const double value : x_ticks.minor) {
        const double at = x.at(value);
        append_move(marks, {at, area.bottom}, {at, area.bottom - minor_length});
        append_move(marks, {at, area.top}, {at, area.top + minor_length});
    }
    for (const Tick& tick : y_ticks.major) {
        const double at = y.at(tick.value);
        append_move(marks, {area.left, at}, {area.left + major_length, at});
        append_move(marks, {area.right, at}, {area.right - major_length, at});
    }
    for (const double value : y_ticks.minor) {
        const double at = y.at(value);
        append_move(marks, {area.left, at}, {area.left + minor_length, at});
        append_move(marks, {area.right, at}, {area.right - minor_length, at});
    }
    out += "<path class=\"tick\" fill=\"none\" d=\"" + marks + "\"/><rect class=\"frame\"";
    attribute(out, "x", area.left);
    attribute(out, "y", area.top);
    attribute(out, "width", area.right - area.left);
    attribute(out, "height", area.bottom - area.top);
    out += "/>";

    double free_from = -1e9; // right end of the last label, so that none overlaps the next
    for (const Tick& tick : x_ticks.major) {
        const double half = 0.5 * tick.label.width(tick_font);
        const double at = x.at(tick.value);
        if (tick.label.empty() || at - half < free_from) {
            continue;
        }
        draw_text(out, {at, area.bottom + 18.0}, "middle", "", tick.label, tick_font);
        free_from = at + half + 6.0;
    }
    double free_below = 1e9;
    for (const Tick& tick : y_ticks.major) {
        const double at = y.at(tick.value);
        if (tick.label.empty() || at + 7.0 > free_below) {
            continue;
        }
        draw_text(out, {area.left - 7.0, at + 4.3}, "end", "", tick.label, tick_font);
        free_below = at - 7.0;
    }

    draw_text(out, {0.5 * (area.left + area.right), area.bottom + 40.0}, "middle", "name",
              plot.x.name, name_font);
    out += "<g transform=\"translate(14.5 " + pixels(0.5 * (area.top + area.bottom)) +
           ") rotate(-90)\">";
    draw_text(out, {0.0, 0.0}, "middle", "name", plot.y.name, name_font);
    out += "</g>";
}

} // namespace searle::rheometry::report
