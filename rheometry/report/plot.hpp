#pragma once

#include "rheometry/report/rich_text.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace searle::rheometry::report {

enum class Scale { linear, logarithmic };
enum class Marker { none, circle, square, diamond, triangle, cross };
enum class Stroke { none, solid, dashed, dotted };

struct Axis {
    RichText name; ///< with the unit
    Scale scale = Scale::linear;
    /// Fixed ends; what is absent follows from the data.
    std::optional<double> low;
    std::optional<double> high;
    /// Data that spread less than this part of their size are drawn as if they spread this much,
    /// so that rounding noise does not fill the figure.
    double least_relative_span = 1e-3;
    /// A linear axis starts at zero when the data come within this part of their span to it.
    double reach_for_zero = 0.5;
};

/// Points in order, joined by a line, marked, or both.
struct Series {
    RichText name; ///< for the legend; empty: not in the legend
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> error; ///< half-lengths of the error bars; empty: none
    /// Plain text shown when pointing at marker k; asked for the drawn ones only. Empty: none.
    std::function<std::string(std::size_t)> tip;
    int colour = 0; ///< 0 ... series_colour_count - 1
    Marker marker = Marker::none;
    bool open_marker = false;
    double marker_spacing =
        0.0; ///< least distance of drawn markers, pixels; 0: as many as can be seen
    Stroke stroke = Stroke::none;
    std::size_t most_line_points = 1500; ///< a longer line is drawn through a choice of its points
    std::string line_tip;                ///< plain text shown when pointing at the line
    bool thin = false;
    bool shows_direction = false;   ///< arrows along the line
    bool reports_error_bars = true; ///< false: not part of DrawnPlot::longest_error_bar
    bool sets_range = true;         ///< false: cut at the axes that the others need
};

/// A stretch of the x axis with a shade.
struct Band {
    double from{};
    double to{};
    std::size_t kind{}; ///< index into Plot::band_kinds
};

struct BandKind {
    std::string name;
    int shade{}; ///< 0 ... 5
};

struct Plot {
    std::string id;     ///< unique within a page: letters, digits, hyphens
    std::string title;  ///< what a screen reader says
    std::string letter; ///< "a" for panel (a); empty: none
    Axis x;
    Axis y;
    std::vector<Series> series;
    std::vector<Band> bands;
    std::vector<BandKind> band_kinds;
    double width = 480.0;
    double plot_height = 290.0; ///< height of the area within the axes, pixels
    /// A linear axis is marked where the quantity is zero.
    bool zero_line = false;
};

/// A drawn plot, and what could not be drawn.
struct DrawnPlot {
    std::string svg;
    /// Marked points that are not finite, or not positive on a logarithmic axis.
    std::size_t dropped_points{};
    /// Marked points left out because they would lie upon others.
    std::size_t thinned_points{};
    /// Longest half-length of an error bar in pixels; below the marker's radius none can be seen.
    double longest_error_bar{};
};

inline constexpr double marker_radius = 3.0;

/// Draws a plot as an <svg> element that needs figure_style() in the page.
/// Awkward data (none, one point, equal, not finite) give a plot with sensible axes.
[[nodiscard]] DrawnPlot draw(const Plot& plot);

/// The plot as a complete SVG file that carries its style.
[[nodiscard]] std::string svg_file(const Plot& plot);

} // namespace searle::rheometry::report
