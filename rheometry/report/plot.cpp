#include "rheometry/report/plot.hpp"

#include "rheometry/report/plot_axes.hpp"
#include "rheometry/report/plot_legend.hpp"
#include "rheometry/report/plot_series.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_path.hpp"
#include "rheometry/report/svg_style.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry::report {

namespace {

double widest_label(const TickMarks& ticks) {
    double widest = 0.0;
    for (const Tick& tick : ticks.major) {
        widest = std::max(widest, tick.label.width(tick_font));
    }
    return widest;
}

// As many labels as fit side by side along the x axis.
int fitting_ticks(const AxisMap& x, double width) {
    int most = 8;
    while (most > 3) {
        const TickMarks ticks = x.ticks(most);
        const double room =
            width / static_cast<double>(std::max<std::size_t>(1, ticks.major.size()));
        if (widest_label(ticks) + 12.0 <= room) {
            break;
        }
        --most;
    }
    return most;
}

void draw_bands(std::string& out, const Plot& plot, const PlotArea& area, const AxisMap& x) {
    for (const Band& band : plot.bands) {
        if (band.kind >= plot.band_kinds.size()) {
            continue;
        }
        const double from = x.can_show(band.from) ? x.at(band.from) : area.left;
        const double to = x.can_show(band.to) ? x.at(band.to) : area.left;
        const double left = std::clamp(std::min(from, to), area.left, area.right);
        const double right = std::clamp(std::max(from, to), area.left, area.right);
        if (!(right > left)) {
            continue;
        }
        draw_shade(out, plot, plot.band_kinds[band.kind], {left, area.top}, right - left,
                   area.bottom - area.top);
    }
}

std::string svg_open(const Plot& plot, double height, bool is_file) {
    std::string out = "<svg class=\"fig\"";
    if (is_file) {
        out += " xmlns=\"http://www.w3.org/2000/svg\"";
        attribute(out, "width", plot.width);
        attribute(out, "height", height);
    }
    out += " viewBox=\"0 0 " + pixels(plot.width) + " " + pixels(height) + "\" role=\"img\"";
    attribute(out, "aria-label", escaped(plot.title));
    out += '>';
    return out;
}

DrawnPlot draw_with(const Plot& plot, bool is_file) {
    AxisMap x = fit_axis(plot, Direction::x);
    AxisMap y = fit_axis(plot, Direction::y);

    const double letter_room = plot.letter.empty() ? 0.0 : 30.0;
    const Legend legend{plot, plot.width - letter_room - 4.0};
    const int y_most = plot.plot_height < 160.0 ? 4 : 7;
    const TickMarks y_ticks = y.ticks(y_most);
    PlotArea area;
    area.left = std::max(46.0, 33.0 + widest_label(y_ticks));
    area.right = plot.width - 16.0;
    area.top = std::max(legend.height(), plot.letter.empty() ? 0.0 : 17.0) + 10.0;
    area.bottom = area.top + plot.plot_height;
    const double height = area.bottom + 48.0;
    x.place(area.left, area.right);
    y.place(area.bottom, area.top);
    const TickMarks x_ticks = x.ticks(fitting_ticks(x, area.right - area.left));

    DrawnPlot drawn;
    std::string& out = drawn.svg;
    out = svg_open(plot, height, is_file);
    if (is_file) {
        out += "<style>";
        out += figure_style();
        out += "</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>";
    }
    out += "<defs><clipPath id=\"" + plot.id + "-area\"><rect";
    attribute(out, "x", area.left);
    attribute(out, "y", area.top);
    attribute(out, "width", area.right - area.left);
    attribute(out, "height", area.bottom - area.top);
    out += "/></clipPath>";
    define_hatches(out, plot);
    out += "</defs>";
    if (!plot.letter.empty()) {
        out += "<text class=\"letter\" x=\"2\" y=\"13\">(" + escaped(plot.letter) + ")</text>";
    }
    legend.draw(out, plot, {letter_room, 0.0});
    draw_bands(out, plot, area, x);
    draw_grid(out, area, x, y, x_ticks, y_ticks);
    draw_axes(out, plot, area, x, y, x_ticks, y_ticks);
    out += "<g clip-path=\"url(#" + plot.id + "-area)\">";
    for (const Series& series : plot.series) {
        draw_series_line(out, series, x, y);
    }
    out += "</g>";
    for (const Series& series : plot.series) {
        const SeriesOutcome outcome = draw_series_points(out, series, x, y);
        drawn.dropped_points += outcome.dropped_points;
        drawn.thinned_points += outcome.thinned_points;
        drawn.longest_error_bar = std::max(drawn.longest_error_bar, outcome.longest_error_bar);
    }
    out += "</svg>";
    return drawn;
}

} // namespace

DrawnPlot draw(const Plot& plot) { return draw_with(plot, false); }

std::string svg_file(const Plot& plot) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + draw_with(plot, true).svg + "\n";
}

} // namespace searle::rheometry::report
