#pragma once

#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_path.hpp"

#include <span>
#include <string>
#include <string_view>

namespace searle::rheometry::report {

/// What a region of a drawing is made of.
enum class Material { fluid, rotor, fixed };

enum class Anchor { start, middle, end };

/// Draughtsman's primitives, in pixels (y downwards), that gather an SVG drawing.
class Drafting {
public:
    Drafting(double width, double height) : width_{width}, height_{height} {}

    /// A filled (hatched when solid) area without outline.
    void region(std::span<const Pixel> corners, Material material);
    void rectangle(Pixel corner, Pixel opposite, Material material);
    /// A visible edge.
    void outline(std::span<const Pixel> points, bool closed = false);
    void line(Pixel from, Pixel to, std::string_view css_class);
    /// Dash-dotted line of symmetry.
    void axis(double x, double top, double bottom);
    /// Dimension between two points: arrows along the line at `along` (its y for a horizontal one,
    /// its x for a vertical one), extension lines from the points, the text beside it. Short
    /// dimensions get their arrows from outside.
    void horizontal_dimension(Pixel from, Pixel to, double along, const RichText& text);
    void vertical_dimension(Pixel from, Pixel to, double along, const RichText& text);
    /// Text on a halo of the page's colour.
    void text(Pixel at, const RichText& content, Anchor anchor = Anchor::start,
              std::string_view css_class = "halo");
    void vertical_text(Pixel at, const RichText& content, std::string_view css_class = "halo");
    /// A thin line with a dot at `target`, and the text at its other end.
    void leader(Pixel target, Pixel label, const RichText& content, Anchor anchor = Anchor::start);
    /// Symbol of a free surface upon a line.
    void free_surface(double x, double y);
    /// Curved arrow around a vertical axis.
    void turning_arrow(Pixel centre, double radius, const RichText& text);
    void arrow_head(Pixel tip, double angle_degrees, std::string_view css_class = "arrow");
    /// Wavy end of a part that goes on.
    void break_line(double from_x, double to_x, double y);
    /// Everything until end_clip() is cut to a circle.
    void begin_circle_clip(Pixel centre, double radius);
    void end_clip();
    void circle(Pixel centre, double radius, std::string_view css_class);
    void arc(Pixel centre, double radius, double from_degrees, double to_degrees,
             std::string_view css_class);
    void path(std::string_view data, std::string_view css_class);

    /// The drawing as an <svg> element; as a file it carries its style.
    [[nodiscard]] std::string svg(std::string_view description, bool as_file) const;

private:
    double width_;
    double height_;
    int clips_ = 0;
    std::string definitions_;
    std::string body_;
};

} // namespace searle::rheometry::report
