#include "rheometry/report/field_figures.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/plot.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/section_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::rheometry::report {
namespace {

namespace name = fields::name;
using fields::SectionFields;

constexpr std::size_t most_pictured = 3;
constexpr int streamlines = 14;
/// Ratio of the largest to the smallest rate from which their axis is logarithmic.
constexpr double spread_for_logarithm = 20.0;

RichText rate_name() {
    RichText text;
    return text.italic("\u03b3\u0307").upright(" in 1/s");
}

/// What tells one row from another: its time, or its speed.
std::string row_text(const SectionFields& section, bool transient, bool rotates) {
    const std::string row = "row " + std::to_string(section.row);
    return row + (transient ? ", " + quantity_text(section.time, "s", 3) : "") + ", " +
           quantity_text(section.speed, rotates ? "rad/s" : "m/s", 3);
}

/// An endless gap: nothing varies along it, so that two rows of points hold all.
bool is_strip(const SectionFields& section) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const fields::SectionPoint& point : section.points) {
        low = std::min(low, point.z);
        high = std::max(high, point.z);
    }
    return std::all_of(
        section.points.begin(), section.points.end(),
        [&](const fields::SectionPoint& point) { return point.z == low || point.z == high; });
}

/// A piece of an endless gap in which the flow varies along it: one vortex of a row of them.
bool is_cell(const SectionFields& section) {
    return std::ranges::any_of(section.outline, [](const fields::OutlineEdge& edge) {
        return edge.kind == fields::OutlineKind::open_end;
    });
}

/// A field along the gaps' lower ends, over the distance from the axis.
Series across(const SectionFields& section, std::string_view field, int component,
              const RichText& label, int colour) {
    Series series;
    series.name = label;
    series.colour = colour;
    series.stroke = Stroke::solid;
    const fields::NodalField* values = section.find(field);
    if (values == nullptr) {
        return series;
    }
    const double floor = std::ranges::min_element(section.points, {}, &fields::SectionPoint::z)->z;
    double before = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        if (section.points[k].z != floor) {
            continue;
        }
        const double r = section.points[k].r;
        // From the inner to the outer gap of a double gap the line has a hole.
        const bool new_gap = k > 0 && section.points[k - 1].z != floor;
        if (new_gap && std::isfinite(before)) {
            series.x.push_back(std::numeric_limits<double>::quiet_NaN());
            series.y.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        before = r;
        series.x.push_back(1e3 * r);
        series.y.push_back(values->values[k * static_cast<std::size_t>(values->components) +
                                          static_cast<std::size_t>(component)]);
    }
    return series;
}

Series over_largest(Series series) {
    double largest = 0.0;
    for (const double each : series.y) {
        largest = std::isfinite(each) ? std::max(largest, std::abs(each)) : largest;
    }
    for (double& each : series.y) {
        each = largest > 0.0 ? each / largest : each;
    }
    return series;
}

Figure strip_figure(const std::vector<const SectionFields*>& pictured, const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    Plot velocity;
    velocity.id = "field-velocity";
    velocity.title = "velocity across the gap";
    Plot rate;
    rate.id = "field-rate";
    rate.title = "rate of shear across the gap";
    RichText place;
    place.italic(rotates ? "r" : "x").upright(" in mm");
    velocity.x.name = rate.x.name = place;
    velocity.x.reach_for_zero = rate.x.reach_for_zero = 0.0;
    velocity.x.least_relative_span = rate.x.least_relative_span = 0.0;
    velocity.y.name.italic("u").upright(" / max |").italic("u").upright("|");
    velocity.zero_line = true;
    rate.y.name = rate_name();
    int colour = 0;
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const SectionFields* section : pictured) {
        const RichText label{row_text(*section, input.transient, rotates)};
        velocity.series.push_back(over_largest(across(*section, name::velocity, 1, label, colour)));
        rate.series.push_back(across(*section, name::shear_rate, 0, label, colour));
        for (const double each : rate.series.back().y) {
            if (each > 0.0) {
                low = std::min(low, each);
                high = std::max(high, each);
            }
        }
        ++colour;
    }
    if (high > spread_for_logarithm * low) {
        rate.y.scale = Scale::logarithmic;
        // What a momentum layer has not reached yet is no part of the picture.
        rate.y.low = std::max(low, high / 1e6);
    }
    FigureBuilder builder;
    builder.add(std::move(velocity));
    builder.add(std::move(rate));
    return builder.finish("The flow across the gap: (a) velocity along the drive over its "
                          "largest, (b) rate of shear; a line ends where a yield stress holds "
                          "the fluid rigid.");
}

/// Around the lower end of the rotor, where there is one: half as high again as the section is
/// wide.
std::optional<SectionWindow> lower_end(const SectionFields& section) {
    double floor = std::numeric_limits<double>::infinity();
    double top = -floor;
    double outside = 0.0;
    for (const fields::SectionPoint& point : section.points) {
        floor = std::min(floor, point.z);
        top = std::max(top, point.z);
        outside = std::max(outside, point.r);
    }
    if (top - floor < 3.0 * outside) {
        return std::nullopt;
    }
    return SectionWindow{0.0, outside, floor, floor + 1.5 * outside};
}

Figure section_figure(const SectionFields& section, const ReportInput& input) {
    Figure figure;
    SectionPicture picture{
        .section = &section, .field = std::string{name::shear_rate}, .name = rate_name()};
    const bool yields = section.yield_stress > 0.0;
    if (yields) {
        picture.blank_field = name::shear_rate;
        picture.blank_below = section.rigid_rate;
        picture.lines.push_back({.field = std::string{name::shear_rate},
                                 .levels = {section.rigid_rate},
                                 .css_class = "yield-surface"});
    }
    const bool has_streamlines = section.find(name::stream_function) != nullptr;
    if (has_streamlines) {
        picture.lines.push_back({.field = std::string{name::stream_function},
                                 .levels = even_levels(section, name::stream_function, streamlines),
                                 .css_class = "streamline",
                                 .dashes_negative = !is_cell(section)});
    }
    const std::string id = "section-" + std::to_string(section.row);
    const auto add = [&](SectionPicture each, const std::string& what) {
        each.letter = std::string(1, static_cast<char>('a' + figure.panels.size()));
        each.id = id + "-" + each.letter;
        each.title = what;
        figure.panels.push_back(draw(each));
    };
    add(picture, "rate of shear on the section");
    std::string caption = "Rate of shear at " + escaped(row_text(section, input.transient, true)) +
                          ", logarithmic colours: (a) " +
                          (is_cell(section) ? "half a wavelength of the gap" : "the whole section");
    if (const auto window = lower_end(section)) {
        picture.window = window;
        add(picture, "rate of shear at the lower end");
        caption += ", (b) its lower end";
    }
    if (has_streamlines) {
        caption +=
            is_cell(section)
                ? "; thin lines: streamlines of the vortex"
                : "; thin lines: streamlines of the secondary flow (dashed: the other sense)";
    }
    caption += ". The rotor's wall is orange.";
    if (yields) {
        caption +=
            " Grey: held rigid by the yield stress; white line: the yield surface, drawn where "
            "the rate is " +
            quantity_text(section.rigid_rate, "1/s", 2) + ".";
    }
    figure.caption = caption;
    return figure;
}

} // namespace

std::vector<Figure> field_figures(const ReportInput& input) {
    std::vector<Figure> figures;
    std::vector<const SectionFields*> pictured;
    for (const std::size_t number : fields::spread_rows(input.fields.size(), most_pictured)) {
        pictured.push_back(&input.fields[number - 1]);
    }
    if (pictured.empty()) {
        return figures;
    }
    const auto sections =
        std::stable_partition(pictured.begin(), pictured.end(),
                              [](const SectionFields* each) { return is_strip(*each); });
    if (const std::vector strips(pictured.begin(), sections); !strips.empty()) {
        figures.push_back(strip_figure(strips, input));
    }
    std::for_each(sections, pictured.end(), [&](const SectionFields* section) {
        figures.push_back(section_figure(*section, input));
    });
    return figures;
}

} // namespace searle::rheometry::report
