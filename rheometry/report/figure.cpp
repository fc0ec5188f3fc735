#include "rheometry/report/figure.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace searle::rheometry::report {

namespace {

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string{noun} + (count == 1 ? "" : "s");
}

bool is_logarithmic(const Plot& plot) {
    return plot.x.scale == Scale::logarithmic || plot.y.scale == Scale::logarithmic;
}

} // namespace

std::string figure_html(const Figure& figure, int number) {
    std::string out = figure.panels.size() > 1 ? "<figure class=\"wide\">" : "<figure>";
    out += "<div class=\"panels\">";
    for (const std::string& panel : figure.panels) {
        out += panel;
    }
    out += "</div><figcaption><b>Figure " + std::to_string(number) + ".</b> " + figure.caption +
           "</figcaption></figure>\n";
    return out;
}

void FigureBuilder::add(Plot plot) { plots_.push_back(std::move(plot)); }

Figure FigureBuilder::finish(std::string caption) {
    Figure figure;
    std::string notes;
    std::size_t thinned = 0;
    for (std::size_t k = 0; k < plots_.size(); ++k) {
        Plot& plot = plots_[k];
        if (plots_.size() > 1) {
            plot.letter = std::string(1, static_cast<char>('a' + k));
        }
        DrawnPlot drawn = draw(plot);
        figure.panels.push_back(std::move(drawn.svg));
        longest_error_bar_ = std::max(longest_error_bar_, drawn.longest_error_bar);
        thinned = std::max(thinned, drawn.thinned_points);
        if (drawn.dropped_points == 0) {
            continue;
        }
        const std::string where = plot.letter.empty() ? "" : " in (" + plot.letter + ")";
        notes += " " + counted(drawn.dropped_points, "point") + " not shown" + where +
                 (is_logarithmic(plot) ? ": undefined, zero, negative or far below all others on a "
                                         "logarithmic axis."
                                       : ": undefined.");
    }
    if (thinned > 0) {
        notes += " For legibility " + counted(thinned, "marker") +
                 " that would lie upon others are left out; the data file has all points.";
    }
    figure.caption = std::move(caption) + notes;
    return figure;
}

} // namespace searle::rheometry::report
