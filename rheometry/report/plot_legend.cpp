#include "rheometry/report/plot_legend.hpp"

#include "rheometry/report/plot_axes.hpp"
#include "rheometry/report/plot_series.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>

namespace searle::rheometry::report {

namespace {

constexpr double sample_width = 24.0;
constexpr double sample_space = 6.0;
constexpr double entry_space = 16.0;
constexpr double row_height = 17.0;
constexpr double font = 12.0;

} // namespace

Legend::Legend(const Plot& plot, double width) {
    const double room = width - sample_width - sample_space;
    const auto add = [&](RichText name, std::string full_name, const Series* series,
                         std::size_t kind) {
        Entry entry;
        entry.name = name.shortened(room, font);
        entry.full_name = std::move(full_name);
        entry.series = series;
        entry.band_kind = kind;
        entries_.push_back(std::move(entry));
    };
    for (const Series& series : plot.series) {
        if (!series.name.empty()) {
            add(series.name, series.name.plain(), &series, 0);
        }
    }
    for (std::size_t kind = 0; kind < plot.band_kinds.size(); ++kind) {
        const std::string& name = plot.band_kinds[kind].name;
        add(RichText{name}, escaped(name), nullptr, kind);
    }
    double x = 0.0;
    for (Entry& entry : entries_) {
        const double taken = sample_width + sample_space + entry.name.width(font);
        if (x > 0.0 && x + taken > width) {
            x = 0.0;
            ++rows_;
        }
        entry.x = x;
        entry.row = rows_;
        x += taken + entry_space;
    }
    if (!entries_.empty()) {
        ++rows_;
    }
}

double Legend::height() const { return rows_ * row_height; }

void Legend::draw(std::string& out, const Plot& plot, Pixel corner) const {
    for (const Entry& entry : entries_) {
        const double x = corner.x + entry.x;
        const double middle = corner.y + (entry.row + 0.5) * row_height;
        if (entry.series == nullptr) {
            draw_shade(out, plot, plot.band_kinds[entry.band_kind], {x, middle - 6.0}, sample_width,
                       12.0);
        } else {
            if (entry.series->stroke != Stroke::none) {
                draw_line(out, {x, middle}, {x + sample_width, middle}, line_class(*entry.series));
            }
            draw_marker(out, entry.series->marker, entry.series->open_marker, entry.series->colour,
                        {x + 0.5 * sample_width, middle}, "");
        }
        out += "<text";
        attribute(out, "x", x + sample_width + sample_space);
        attribute(out, "y", middle + 4.2);
        out += '>';
        const bool cut = entry.name.plain() != entry.full_name;
        if (cut) {
            out += "<title>" + entry.full_name + "</title>";
        }
        out += entry.name.svg(font);
        out += "</text>";
    }
}

std::string hatch_id(const Plot& plot, int shade) {
    return plot.id + "-hatch-" + std::to_string(shade);
}

void define_hatches(std::string& out, const Plot& plot) {
    // Directions of the hatch tell the shades apart in print; shade 0 has none.
    constexpr int angle[] = {0, 45, -45, 90, 0, 20};
    constexpr int spacing[] = {8, 8, 7, 8, 8, 9};
    for (const BandKind& kind : plot.band_kinds) {
        const auto shade = static_cast<std::size_t>(std::clamp(kind.shade, 0, 5));
        if (shade == 0) {
            continue;
        }
        const std::string pitch = std::to_string(spacing[shade]);
        out += "<pattern id=\"" + hatch_id(plot, kind.shade) + "\" width=\"" + pitch +
               "\" height=\"" + pitch +
               "\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(" +
               std::to_string(angle[shade]) + ")\"><line class=\"hatch hatch-" +
               std::to_string(shade) + "\" x1=\"0\" y1=\"0\" x2=\"" + pitch +
               "\" y2=\"0\"/></pattern>";
    }
}

void draw_shade(std::string& out, const Plot& plot, const BandKind& kind, Pixel corner,
                double width, double height) {
    const auto rectangle = [&](std::string_view paint_name, std::string_view paint) {
        out += "<rect";
        attribute(out, paint_name, paint);
        attribute(out, "x", corner.x);
        attribute(out, "y", corner.y);
        attribute(out, "width", width);
        attribute(out, "height", height);
        out += "/>";
    };
    rectangle("class", "tint-" + std::to_string(std::clamp(kind.shade, 0, 5)));
    if (kind.shade > 0) {
        rectangle("fill", "url(#" + hatch_id(plot, kind.shade) + ")");
    }
}

} // namespace searle::rheometry::report
