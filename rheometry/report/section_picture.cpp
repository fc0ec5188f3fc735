#include "rheometry/report/section_picture.hpp"

#include "rheometry/report/colour_scale.hpp"
#include "rheometry/report/contours.hpp"
#include "rheometry/report/svg_path.hpp"
#include "rheometry/report/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry::report {
namespace {

using fields::OutlineKind;
using fields::SectionFields;
using fields::SectionPoint;

constexpr int bands = 24;
constexpr double margin = 8.0;
constexpr double bar_width = 14.0;
constexpr double label_width = 62.0;
constexpr double head = 24.0;      ///< above the section: letter and name of the quantity
constexpr double extremes = 0.005; ///< share of the area that may lie beyond each end of the scale

/// Where the half-plane lies in the picture.
struct Frame {
    SectionWindow window;
    double per_metre{};

    [[nodiscard]] Pixel at(SectionPoint point) const {
        return {margin + (point.r - window.r_low) * per_metre,
                head + (window.z_high - point.z) * per_metre};
    }
    [[nodiscard]] double width() const { return (window.r_high - window.r_low) * per_metre; }
    [[nodiscard]] double height() const { return (window.z_high - window.z_low) * per_metre; }
};

SectionWindow whole(const SectionFields& section) {
    SectionWindow window{};
    bool first = true;
    for (const SectionPoint& point : section.points) {
        window.r_low = first ? point.r : std::min(window.r_low, point.r);
        window.r_high = first ? point.r : std::max(window.r_high, point.r);
        window.z_low = first ? point.z : std::min(window.z_low, point.z);
        window.z_high = first ? point.z : std::max(window.z_high, point.z);
        first = false;
    }
    return window;
}

Frame frame_of(const SectionPicture& picture) {
    Frame frame{picture.window ? *picture.window : whole(*picture.section)};
    const double room = picture.width - 3.0 * margin - bar_width - label_width;
    const double across = std::max(frame.window.r_high - frame.window.r_low, 1e-12);
    const double along = std::max(frame.window.z_high - frame.window.z_low, 1e-12);
    frame.per_metre = std::min(room / across, (picture.most_height - head - 2.0 * margin) / along);
    return frame;
}

bool is_near(const Frame& frame, const Polyline& line) {
    const SectionWindow& w = frame.window;
    return std::any_of(line.begin(), line.end(), [&](const SectionPoint& p) {
        return p.r >= w.r_low && p.r <= w.r_high && p.z >= w.z_low && p.z <= w.z_high;
    });
}

/// Path data of lines, without points that lie within a third of a pixel of the one before.
std::string path_of(const Frame& frame, const std::vector<Polyline>& lines, bool closed) {
    constexpr double least = 0.33;
    std::string path;
    for (const Polyline& line : lines) {
        // A loop around the window has no point inside, but may cover it.
        if (!closed && !is_near(frame, line)) {
            continue;
        }
        std::vector<Pixel> points;
        for (std::size_t k = 0; k < line.size(); ++k) {
            const Pixel at = frame.at(line[k]);
            if (points.empty() || k + 1 == line.size() ||
                std::hypot(at.x - points.back().x, at.y - points.back().y) >= least) {
                points.push_back(at);
            }
        }
        if (points.size() >= (closed ? 3U : 2U)) {
            path += path_through(points, closed);
        }
    }
    return path;
}

/// The colour scale's coordinate of a value, and its ends.
struct ColourRange {
    Scale scale{};
    double low{};
    double high{};

    [[nodiscard]] double share(double value) const {
        return scale == Scale::logarithmic ? std::log(value / low) / std::log(high / low)
                                           : (value - low) / (high - low);
    }
    [[nodiscard]] double value(double share) const {
        return scale == Scale::logarithmic ? low * std::pow(high / low, share)
                                           : low + share * (high - low);
    }
};

/// The triangles of a scalar that are not shaded as rigid.
DrawnScalar without_rigid(const SectionPicture& picture, const DrawnScalar& scalar) {
    if (picture.blank_field.empty()) {
        return scalar;
    }
    const DrawnScalar blank = drawn_scalar(*picture.section, picture.blank_field);
    DrawnScalar rest = scalar;
    rest.triangles.clear();
    rest.area.clear();
    for (std::size_t t = 0;
         t < scalar.triangles.size() && blank.triangles.size() == scalar.triangles.size(); ++t) {
        const auto& corner = blank.triangles[t];
        const bool flows = std::any_of(corner.begin(), corner.end(), [&](std::uint32_t k) {
            return blank.values[k] > picture.blank_below;
        });
        if (flows) {
            rest.triangles.push_back(scalar.triangles[t]);
            rest.area.push_back(scalar.area[t]);
        }
    }
    return rest.triangles.empty() ? scalar : rest;
}

ColourRange range_of(const SectionPicture& picture, const DrawnScalar& scalar) {
    // On a logarithmic scale no more than these decades: below lies what numerics leave of zero.
    constexpr double most_ratio = 1e4;
    ColourRange range{picture.scale, picture.low.value_or(area_quantile(scalar, extremes)),
                      picture.high.value_or(area_quantile(scalar, 1.0 - extremes))};
    if (range.scale == Scale::logarithmic) {
        if (!(range.high > 0.0)) {
            range.scale = Scale::linear;
        } else if (!picture.low) {
            range.low = std::max(range.low, range.high / most_ratio);
        }
    }
    const double least = range.scale == Scale::logarithmic
                             ? range.high / 1.05
                             : range.high - 1e-3 * std::max(std::abs(range.high), 1e-300);
    range.low = std::min(range.low, least);
    return range;
}

void draw_colours(std::string& out, const Frame& frame, const DrawnScalar& scalar,
                  const ColourRange& range) {
    const auto fill = [&](const std::string& path, double share) {
        if (!path.empty()) {
            out += "<path stroke=\"none\" fill-rule=\"evenodd\"";
            attribute(out, "fill", scale_colour(share));
            attribute(out, "d", path);
            out += "/>";
        }
    };
    for (int band = 0; band < bands; ++band) {
        const double level = band == 0 ? -HUGE_VAL : range.value(static_cast<double>(band) / bands);
        fill(path_of(frame, region_above(scalar, level), true), (band + 0.5) / bands);
    }
}

void draw_bar(std::string& out, const SectionPicture& picture, const Frame& frame,
              const ColourRange& range) {
    const double left = 2.0 * margin + frame.width();
    const double height = std::min(frame.height(), 220.0);
    const double top = head + 0.5 * (frame.height() - height);
    for (int band = 0; band < bands; ++band) {
        out += "<rect";
        attribute(out, "x", left);
        attribute(out, "y", top + height * (bands - 1 - band) / bands);
        attribute(out, "width", bar_width);
        attribute(out, "height", height / bands + 0.5);
        attribute(out, "fill", scale_colour((band + 0.5) / bands));
        out += "/>";
    }
    out += "<rect class=\"frame\"";
    attribute(out, "x", left);
    attribute(out, "y", top);
    attribute(out, "width", bar_width);
    attribute(out, "height", height);
    out += "/>";
    const TickMarks ticks = range.scale == Scale::logarithmic
                                ? logarithmic_ticks(range.low, range.high, 7)
                                : linear_ticks(range.low, range.high, 6);
    for (const Tick& tick : ticks.major) {
        const double y = top + height * (1.0 - range.share(tick.value));
        draw_line(out, {left + bar_width, y}, {left + bar_width + 4.0, y}, "tick");
        out += "<text";
        attribute(out, "x", left + bar_width + 7.0);
        attribute(out, "y", y + 4.0);
        out += ">" + tick.label.svg(12.0) + "</text>";
    }
    out += "<text class=\"name\"";
    attribute(out, "x", left);
    attribute(out, "y", top - 9.0);
    out += ">" + picture.name.svg(13.0) + "</text>";
}

std::string_view outline_class(OutlineKind kind) {
    switch (kind) {
    case OutlineKind::rotor:
        return "rotor-wall";
    case OutlineKind::axis:
        return "axis-line";
    case OutlineKind::free_surface:
    case OutlineKind::open_end:
        return "hairline";
    case OutlineKind::fixed_wall:
        break;
    }
    return "outline";
}

void draw_outline(std::string& out, const Frame& frame, const SectionFields& section) {
    for (const OutlineKind kind :
         {OutlineKind::axis, OutlineKind::open_end, OutlineKind::free_surface,
          OutlineKind::fixed_wall, OutlineKind::rotor}) {
        std::string path;
        for (const fields::OutlineEdge& edge : section.outline) {
            if (edge.kind == kind) {
                const std::array<Pixel, 2> ends{frame.at(section.points[edge.ends[0]]),
                                                frame.at(section.points[edge.ends[1]])};
                path += path_through(ends);
            }
        }
        if (!path.empty()) {
            out += "<path";
            attribute(out, "class", outline_class(kind));
            attribute(out, "d", path);
            out += "/>";
        }
    }
}

void draw_lines(std::string& out, const Frame& frame, const SectionFields& section,
                const ContourLines& lines) {
    const DrawnScalar scalar = drawn_scalar(section, lines.field);
    for (const double level : lines.levels) {
        const std::string path = path_of(frame, level_lines(scalar, level), false);
        if (!path.empty()) {
            out += "<path";
            attribute(out, "class",
                      escaped(lines.css_class) +
                          (lines.dashes_negative && level < 0.0 ? " dashed" : ""));
            attribute(out, "d", path);
            out += "/>";
        }
    }
}

} // namespace

std::string draw(const SectionPicture& picture) {
    const SectionFields& section = *picture.section;
    const Frame frame = frame_of(picture);
    const double height = head + frame.height() + margin;
    std::string out = "<svg class=\"fig\" role=\"img\"";
    attribute(out, "viewBox", "0 0 " + pixels(picture.width) + " " + pixels(height));
    attribute(out, "aria-label", escaped(picture.title));
    out += "><defs><clipPath";
    attribute(out, "id", escaped(picture.id) + "-clip");
    out += "><rect";
    attribute(out, "x", margin - 1.0);
    attribute(out, "y", head - 1.0);
    attribute(out, "width", frame.width() + 2.0);
    attribute(out, "height", frame.height() + 2.0);
    out += "/></clipPath></defs><g";
    attribute(out, "clip-path", "url(#" + escaped(picture.id) + "-clip)");
    out += ">";
    const DrawnScalar scalar = drawn_scalar(section, picture.field);
    const bool has_colours = !scalar.triangles.empty();
    const ColourRange range =
        has_colours ? range_of(picture, without_rigid(picture, scalar)) : ColourRange{};
    if (has_colours) {
        draw_colours(out, frame, scalar, range);
    }
    if (!picture.blank_field.empty()) {
        DrawnScalar rigid = drawn_scalar(section, picture.blank_field);
        for (double& value : rigid.values) {
            value = -value;
        }
        const std::string path = path_of(frame, region_above(rigid, -picture.blank_below), true);
        if (!path.empty()) {
            out += "<path class=\"rigid\" fill-rule=\"evenodd\"";
            attribute(out, "d", path);
            out += "/>";
        }
    }
    for (const ContourLines& lines : picture.lines) {
        draw_lines(out, frame, section, lines);
    }
    draw_outline(out, frame, section);
    out += "</g>";
    if (has_colours) {
        draw_bar(out, picture, frame, range);
    }
    if (!picture.letter.empty()) {
        out += "<text class=\"letter\"";
        attribute(out, "x", margin);
        attribute(out, "y", 14.0);
        out += ">(" + escaped(picture.letter) + ")</text>";
    }
    return out + "</svg>";
}

std::vector<double> even_levels(const SectionFields& section, std::string_view field, int count) {
    const DrawnScalar scalar = drawn_scalar(section, field);
    std::vector<double> levels;
    if (scalar.triangles.empty()) {
        return levels;
    }
    const auto [low, high] = std::minmax_element(scalar.values.begin(), scalar.values.end());
    for (int k = 1; k <= count; ++k) {
        levels.push_back(*low + (*high - *low) * k / (count + 1));
    }
    return levels;
}

} // namespace searle::rheometry::report
