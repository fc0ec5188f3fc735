#include "rheometry/report/plot_series.hpp"

#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_style.hpp"
#include "rheometry/report/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace searle::rheometry::report {

namespace {

constexpr std::size_t most_markers = 400;

int colour_index(int colour) {
    return ((colour % series_colour_count) + series_colour_count) % series_colour_count;
}

std::vector<Pixel> places_of(const Series& series, const AxisMap& x, const AxisMap& y) {
    const std::size_t count = std::min(series.x.size(), series.y.size());
    std::vector<Pixel> places;
    places.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        places.push_back({x.at(series.x[k]), y.at(series.y[k])});
    }
    return places;
}

bool is_finite(const Pixel& place) { return std::isfinite(place.x) && std::isfinite(place.y); }

// Arrow heads beside the line, to the left of its direction, so that the two branches of a loop
// that nearly coincide show theirs on opposite sides.
void draw_arrows(std::string& out, const std::vector<Pixel>& places, int colour) {
    std::vector<Pixel> path;
    for (const Pixel& place : places) {
        if (is_finite(place)) {
            path.push_back(place);
        }
    }
    std::vector<double> length{0.0};
    for (std::size_t k = 1; k < path.size(); ++k) {
        length.push_back(length.back() +
                         std::hypot(path[k].x - path[k - 1].x, path[k].y - path[k - 1].y));
    }
    if (path.size() < 2 || length.back() < 40.0) {
        return;
    }
    const int arrows = length.back() > 250.0 ? 2 : 1;
    for (int arrow = 0; arrow < arrows; ++arrow) {
        const double wanted = length.back() * (0.5 + arrow) / arrows;
        const auto after = std::lower_bound(length.begin() + 1, length.end(), wanted);
        const auto k = static_cast<std::size_t>(std::min<std::ptrdiff_t>(
            after - length.begin(), static_cast<std::ptrdiff_t>(path.size()) - 1));
        const double dx = path[k].x - path[k - 1].x;
        const double dy = path[k].y - path[k - 1].y;
        const double step = std::hypot(dx, dy);
        if (step == 0.0) {
            continue;
        }
        constexpr double aside = 11.0;
        const Pixel at{0.5 * (path[k].x + path[k - 1].x) + aside * dy / step,
                       0.5 * (path[k].y + path[k - 1].y) - aside * dx / step};
        out += "<path class=\"mark-" + std::to_string(colour) +
               "\" d=\"M6 0L-5 4.2L-2.5 0L-5 -4.2Z\"" + " transform=\"translate(" + pixels(at.x) +
               " " + pixels(at.y) + ") rotate(" +
               pixels(std::atan2(dy, dx) * 180.0 / std::numbers::pi) + ")\"/>";
    }
}

void draw_error_bar(std::string& path, const AxisMap& y, double value, double error, double x,
                    double& longest) {
    if (!std::isfinite(error) || error <= 0.0) {
        return;
    }
    const double top = y.at(std::min(value + error, y.high()));
    const double lower = value - error;
    const double bottom = y.can_show(lower) ? y.at(std::max(lower, y.low())) : y.low_pixel();
    if (!std::isfinite(top) || !std::isfinite(bottom)) {
        return;
    }
    longest = std::max(longest, 0.5 * std::abs(bottom - top));
    constexpr double cap = 3.0;
    path += "M" + pixels(x - cap) + " " + pixels(top) + "h" + pixels(2 * cap) + "m" + pixels(-cap) +
            " 0V" + pixels(bottom) + "m" + pixels(-cap) + " 0h" + pixels(2 * cap);
}

} // namespace

std::string line_class(const Series& series) {
    std::string css = "line line-" + std::to_string(colour_index(series.colour));
    if (series.stroke == Stroke::dashed) {
        css += " dashed";
    }
    if (series.stroke == Stroke::dotted) {
        css += " dotted";
    }
    if (series.thin) {
        css += " thin";
    }
    return css;
}

void draw_marker(std::string& out, Marker marker, bool open, int colour, Pixel at,
                 std::string_view tip) {
    if (marker == Marker::none) {
        return;
    }
    constexpr double r = marker_radius;
    const std::string css =
        std::string{"mark mark-"} + std::to_string(colour_index(colour)) + (open ? " open" : "");
    std::string_view element = "path";
    if (marker == Marker::circle) {
        element = "circle";
        out += "<circle";
        attribute(out, "class", css);
        attribute(out, "cx", at.x);
        attribute(out, "cy", at.y);
        attribute(out, "r", open ? r - 0.3 : r - 0.5);
    } else {
        out += "<path";
        attribute(out, "class", css);
        std::string d = "M" + pixels(at.x) + " " + pixels(at.y);
        switch (marker) {
        case Marker::square:
            d += "m-2.6 -2.6h5.2v5.2h-5.2z";
            break;
        case Marker::diamond:
            d += "m0 -3.7l3.7 3.7l-3.7 3.7l-3.7 -3.7z";
            break;
        case Marker::triangle:
            d += "m0 -3.6l3.4 6h-6.8z";
            break;
        default:
            d += "m-2.8 -2.8l5.6 5.6m0 -5.6l-5.6 5.6";
            break;
        }
        attribute(out, "d", d);
    }
    if (tip.empty()) {
        out += "/>";
        return;
    }
    out += "><title>" + escaped(tip) + "</title></";
    out += element;
    out += '>';
}

void draw_series_line(std::string& out, const Series& series, const AxisMap& x, const AxisMap& y) {
    if (series.stroke == Stroke::none) {
        return;
    }
    const std::vector<Pixel> places = places_of(series, x, y);
    std::vector<Pixel> kept;
    if (places.size() <= series.most_line_points) {
        kept = places;
    } else {
        for (const std::size_t k : thinned_by_distance(places, series.most_line_points)) {
            kept.push_back(places[k]);
        }
    }
    out += "<path";
    attribute(out, "class", line_class(series));
    attribute(out, "d", path_through(kept));
    out +=
        series.line_tip.empty() ? "/>" : "><title>" + escaped(series.line_tip) + "</title></path>";
    if (series.shows_direction) {
        draw_arrows(out, kept, colour_index(series.colour));
    }
}

SeriesOutcome draw_series_points(std::string& out, const Series& series, const AxisMap& x,
                                 const AxisMap& y) {
    SeriesOutcome outcome;
    if (series.marker == Marker::none) {
        return outcome;
    }
    const std::vector<Pixel> places = places_of(series, x, y);
    std::vector<Pixel> inside = places;
    constexpr double slack = 0.5; // a point on the frame belongs to the plot
    for (Pixel& place : inside) {
        const bool shown = is_finite(place) && place.x >= x.low_pixel() - slack &&
                           place.x <= x.high_pixel() + slack && place.y <= y.low_pixel() + slack &&
                           place.y >= y.high_pixel() - slack;
        if (shown) {
            continue;
        }
        place.x = std::numeric_limits<double>::quiet_NaN();
        ++outcome.dropped_points;
    }
    const std::vector<std::size_t> kept = series.marker_spacing > 0.0
                                              ? spaced_by(inside, series.marker_spacing)
                                              : thinned_by_distance(inside, most_markers);
    outcome.thinned_points = places.size() - outcome.dropped_points - kept.size();

    std::string bars;
    for (const std::size_t k : kept) {
        if (k < series.error.size()) {
            draw_error_bar(bars, y, series.y[k], series.error[k], places[k].x,
                           outcome.longest_error_bar);
        }
    }
    if (!series.reports_error_bars) {
        outcome.longest_error_bar = 0.0;
    }
    if (!bars.empty()) {
        out += "<path class=\"bar line-" + std::to_string(colour_index(series.colour)) + "\" d=\"" +
               bars + "\"/>";
    }
    for (const std::size_t k : kept) {
        draw_marker(out, series.marker, series.open_marker, series.colour, places[k],
                    series.tip ? series.tip(k) : std::string{});
    }
    return outcome;
}

} // namespace searle::rheometry::report
