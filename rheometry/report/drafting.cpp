#include "rheometry/report/drafting.hpp"

#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace searle::rheometry::report {

namespace {

constexpr double font = 12.0;
constexpr double outside_arrow = 16.0;
constexpr double least_inside = 26.0; // shorter dimensions get their arrows from outside

std::string_view name_of_anchor(Anchor anchor) {
    switch (anchor) {
    case Anchor::middle:
        return "middle";
    case Anchor::end:
        return "end";
    default:
        return "start";
    }
}

constexpr std::string_view hatch_patterns =
    "<pattern id=\"drawing-rotor\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><rect class=\"rotor\" width=\"6\" height=\"6\"/>"
    "<line class=\"rotor-hatch\" x1=\"0\" y1=\"0\" x2=\"6\" y2=\"0\"/></pattern>"
    "<pattern id=\"drawing-fixed\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(-45)\"><rect class=\"fixed\" width=\"5\" height=\"5\"/>"
    "<line class=\"fixed-hatch\" x1=\"0\" y1=\"0\" x2=\"5\" y2=\"0\"/></pattern>";

} // namespace

void Drafting::region(std::span<const Pixel> corners, Material material) {
    body_ += "<path";
    switch (material) {
    case Material::fluid:
        body_ += " class=\"fluid\"";
        break;
    case Material::rotor:
        body_ += " fill=\"url(#drawing-rotor)\"";
        break;
    case Material::fixed:
        body_ += " fill=\"url(#drawing-fixed)\"";
        break;
    }
    body_ += " d=\"" + path_through(corners, true) + "\"/>";
}

void Drafting::rectangle(Pixel corner, Pixel opposite, Material material) {
    const std::array<Pixel, 4> corners{
        {corner, {opposite.x, corner.y}, opposite, {corner.x, opposite.y}}};
    region(corners, material);
}

void Drafting::outline(std::span<const Pixel> points, bool closed) {
    body_ += "<path class=\"outline\" d=\"" + path_through(points, closed) + "\"/>";
}

void Drafting::line(Pixel from, Pixel to, std::string_view css_class) {
    draw_line(body_, from, to, css_class);
}

void Drafting::axis(double x, double top, double bottom) {
    line({x, top}, {x, bottom}, "axis-line");
}

void Drafting::arrow_head(Pixel tip, double angle_degrees, std::string_view css_class) {
    body_ += "<path class=\"" + std::string{css_class} +
             "\" d=\"M0 0L-8 2.6L-8 -2.6Z\" transform=\"translate(" + pixels(tip.x) + " " +
             pixels(tip.y) + ") rotate(" + pixels(angle_degrees) + ")\"/>";
}

void Drafting::horizontal_dimension(Pixel from, Pixel to, double along, const RichText& content) {
    if (from.x > to.x) {
        std::swap(from, to);
    }
    const auto extension = [&](const Pixel& point) {
        const double beyond = along > point.y ? 4.0 : -4.0;
        line({point.x, point.y}, {point.x, along + beyond}, "extension");
    };
    extension(from);
    extension(to);
    const double length = to.x - from.x;
    const double width = content.width(font);
    if (length >= least_inside) {
        line({from.x, along}, {to.x, along}, "dimension");
        arrow_head({from.x, along}, 180.0);
        arrow_head({to.x, along}, 0.0);
    } else {
        line({from.x - outside_arrow, along}, {to.x + outside_arrow, along}, "dimension");
        arrow_head({from.x, along}, 0.0);
        arrow_head({to.x, along}, 180.0);
    }
    if (length >= width + 4.0) {
        text({0.5 * (from.x + to.x), along - 4.0}, content, Anchor::middle);
    } else {
        text({to.x + (length >= least_inside ? 6.0 : outside_arrow + 4.0), along + 4.0}, content);
    }
}

void Drafting::vertical_dimension(Pixel from, Pixel to, double along, const RichText& content) {
    if (from.y > to.y) {
        std::swap(from, to);
    }
    const auto extension = [&](const Pixel& point) {
        const double beyond = along > point.x ? 4.0 : -4.0;
        line({point.x, point.y}, {along + beyond, point.y}, "extension");
    };
    extension(from);
    extension(to);
    const double length = to.y - from.y;
    if (length >= least_inside) {
        line({along, from.y}, {along, to.y}, "dimension");
        arrow_head({along, from.y}, -90.0);
        arrow_head({along, to.y}, 90.0);
    } else {
        line({along, from.y - outside_arrow}, {along, to.y + outside_arrow}, "dimension");
        arrow_head({along, from.y}, 90.0);
        arrow_head({along, to.y}, -90.0);
    }
    const double middle = 0.5 * (from.y + to.y);
    if (length >= content.width(font) + 4.0) {
        vertical_text({along - 4.0, middle}, content);
    } else {
        text({along + 6.0, middle + 4.0}, content);
    }
}

void Drafting::text(Pixel at, const RichText& content, Anchor anchor, std::string_view css_class) {
    body_ += "<text";
    attribute(body_, "class", css_class);
    attribute(body_, "x", at.x);
    attribute(body_, "y", at.y);
    attribute(body_, "text-anchor", name_of_anchor(anchor));
    body_ += '>';
    body_ += content.svg(font);
    body_ += "</text>";
}

void Drafting::vertical_text(Pixel at, const RichText& content, std::string_view css_class) {
    body_ += "<g transform=\"translate(" + pixels(at.x) + " " + pixels(at.y) + ") rotate(-90)\">";
    text({0.0, 0.0}, content, Anchor::middle, css_class);
    body_ += "</g>";
}

void Drafting::leader(Pixel target, Pixel label, const RichText& content, Anchor anchor) {
    const double back = anchor == Anchor::end ? 4.0 : -4.0;
    line({label.x + back, label.y - 4.0}, target, "hairline");
    circle(target, 1.8, "arrow");
    text(label, content, anchor);
}

void Drafting::free_surface(double x, double y) {
    const std::array<Pixel, 3> triangle{{{x - 5.0, y - 9.0}, {x + 5.0, y - 9.0}, {x, y}}};
    body_ += "<path class=\"hairline\" d=\"" + path_through(triangle, true) + "\"/>";
    line({x - 5.0, y + 3.0}, {x + 5.0, y + 3.0}, "hairline");
    line({x - 2.5, y + 6.0}, {x + 2.5, y + 6.0}, "hairline");
}

void Drafting::turning_arrow(Pixel centre, double radius, const RichText& content) {
    const double flat = 0.35 * radius;
    const Pixel tip{centre.x + radius * 0.77, centre.y - flat * 0.64};
    body_ += "<path class=\"dimension\" d=\"M" + pixels(centre.x - radius * 0.77) + " " +
             pixels(centre.y - flat * 0.64) + "A" + pixels(radius) + " " + pixels(flat) +
             " 0 1 0 " + pixels(tip.x) + " " + pixels(tip.y) + "\"/>";
    arrow_head(tip, -145.0);
    text({centre.x + radius + 6.0, centre.y + 4.0}, content);
}

void Drafting::break_line(double from_x, double to_x, double y) {
    const double middle = 0.5 * (from_x + to_x);
    const double bend = std::min(5.0, 0.2 * (to_x - from_x));
    body_ += "<path class=\"hairline\" d=\"M" + pixels(from_x) + " " + pixels(y) + "Q" +
             pixels(0.5 * (from_x + middle)) + " " + pixels(y - bend) + " " + pixels(middle) + " " +
             pixels(y) + "T" + pixels(to_x) + " " + pixels(y) + "\"/>";
}

void Drafting::begin_circle_clip(Pixel centre, double radius) {
    const std::string id = "drawing-clip-" + std::to_string(clips_++);
    definitions_ += "<clipPath id=\"" + id + "\"><circle";
    attribute(definitions_, "cx", centre.x);
    attribute(definitions_, "cy", centre.y);
    attribute(definitions_, "r", radius);
    definitions_ += "/></clipPath>";
    body_ += "<g clip-path=\"url(#" + id + ")\">";
}

void Drafting::end_clip() { body_ += "</g>"; }

void Drafting::circle(Pixel centre, double radius, std::string_view css_class) {
    body_ += "<circle";
    attribute(body_, "class", css_class);
    attribute(body_, "cx", centre.x);
    attribute(body_, "cy", centre.y);
    attribute(body_, "r", radius);
    body_ += "/>";
}

void Drafting::arc(Pixel centre, double radius, double from_degrees, double to_degrees,
                   std::string_view css_class) {
    const auto at = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180.0;
        return pixels(centre.x + radius * std::cos(angle)) + " " +
               pixels(centre.y + radius * std::sin(angle));
    };
    const bool large = std::abs(to_degrees - from_degrees) > 180.0;
    path("M" + at(from_degrees) + "A" + pixels(radius) + " " + pixels(radius) + " 0 " +
             (large ? "1 " : "0 ") + (to_degrees > from_degrees ? "1 " : "0 ") + at(to_degrees),
         css_class);
}

void Drafting::path(std::string_view data, std::string_view css_class) {
    body_ += "<path";
    attribute(body_, "class", css_class);
    attribute(body_, "d", data);
    body_ += "/>";
}

std::string Drafting::svg(std::string_view description, bool as_file) const {
    std::string out = as_file ? "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" : "";
    out += "<svg class=\"fig\"";
    if (as_file) {
        out += " xmlns=\"http://www.w3.org/2000/svg\"";
        attribute(out, "width", width_);
        attribute(out, "height", height_);
    }
    out += " viewBox=\"0 0 " + pixels(width_) + " " + pixels(height_) + "\" role=\"img\"";
    attribute(out, "aria-label", escaped(description));
    out += '>';
    if (as_file) {
        out += "<style>";
        out += figure_style();
        out += "</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>";
    }
    out += "<defs>";
    out += hatch_patterns;
    out += definitions_ + "</defs>" + body_ + "</svg>";
    if (as_file) {
        out += "\n";
    }
    return out;
}

} // namespace searle::rheometry::report
