#pragma once

#include "rheometry/report/plot.hpp"
#include "rheometry/report/svg_path.hpp"
#include "rheometry/report/ticks.hpp"

#include <string>

namespace searle::rheometry::report {

/// An axis with its ends decided: numbers to pixels.
class AxisMap {
public:
    AxisMap(Scale scale, double low, double high);

    /// Pixels of the low and the high end.
    void place(double low_pixel, double high_pixel);
    [[nodiscard]] bool can_show(double value) const;
    /// NaN where the axis cannot show the value.
    [[nodiscard]] double at(double value) const;
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] double low_pixel() const { return low_pixel_; }
    [[nodiscard]] double high_pixel() const { return high_pixel_; }
    [[nodiscard]] TickMarks ticks(int most) const;
    /// True when the value lies within the ends.
    [[nodiscard]] bool contains(double value) const { return value >= low_ && value <= high_; }

private:
    Scale scale_;
    double low_;
    double high_;
    double low_pixel_ = 0.0;
    double high_pixel_ = 1.0;
};

enum class Direction { x, y };

/// Ends that show all series of the plot, and their error bars along y.
[[nodiscard]] AxisMap fit_axis(const Plot& plot, Direction direction);

/// The area within the axes, pixels.
struct PlotArea {
    double left{};
    double top{};
    double right{};
    double bottom{};
};

/// Grid lines, to be drawn under the data.
void draw_grid(std::string& out, const PlotArea& area, const AxisMap& x, const AxisMap& y,
               const TickMarks& x_ticks, const TickMarks& y_ticks);

/// Frame, tick marks, labels and the axes' names.
void draw_axes(std::string& out, const Plot& plot, const PlotArea& area, const AxisMap& x,
               const AxisMap& y, const TickMarks& x_ticks, const TickMarks& y_ticks);

inline constexpr double tick_font = 12.0;
inline constexpr double name_font = 13.0;

} // namespace searle::rheometry::report
