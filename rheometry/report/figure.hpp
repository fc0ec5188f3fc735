#pragma once

#include "rheometry/report/plot.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// A figure of the page, still without its number.
struct Figure {
    std::vector<std::string> panels; ///< SVG elements, side by side where there is room
    std::string caption;             ///< HTML
};

/// HTML of a figure with its number.
[[nodiscard]] std::string figure_html(const Figure& figure, int number);

/// Gathers panels and what their drawing left out, for one honest caption.
class FigureBuilder {
public:
    /// Draws a panel; panels get the letters a, b, ... when there are several.
    void add(Plot plot);
    [[nodiscard]] bool empty() const { return plots_.empty(); }
    /// `caption` is HTML; sentences on dropped and thinned points follow it.
    [[nodiscard]] Figure finish(std::string caption);
    /// Longest error bar of the panels added so far, pixels; known after finish() only.
    [[nodiscard]] double longest_error_bar() const { return longest_error_bar_; }

private:
    std::vector<Plot> plots_;
    double longest_error_bar_{};
};

} // namespace searle::rheometry::report
