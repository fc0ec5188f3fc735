#pragma once

#include "rheometry/report/plot.hpp"
#include "rheometry/report/plot_axes.hpp"

#include <cstddef>
#include <string>

namespace searle::rheometry::report {

/// What drawing one series left out or measured; see DrawnPlot.
struct SeriesOutcome {
    std::size_t dropped_points{};
    std::size_t thinned_points{};
    double longest_error_bar{};
};

/// The line of a series and the arrows along it, if it has any; to be clipped to the plot's area.
void draw_series_line(std::string& out, const Series& series, const AxisMap& x, const AxisMap& y);

/// Error bars and markers of a series, if it has any.
SeriesOutcome draw_series_points(std::string& out, const Series& series, const AxisMap& x,
                                 const AxisMap& y);

/// One marker at a place; `tip` (plain text) may be empty.
void draw_marker(std::string& out, Marker marker, bool open, int colour, Pixel at,
                 std::string_view tip);

/// Classes of a series' line: colour, dashes, thickness.
[[nodiscard]] std::string line_class(const Series& series);

} // namespace searle::rheometry::report
