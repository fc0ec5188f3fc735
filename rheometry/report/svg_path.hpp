#pragma once

#include <span>
#include <string>
#include <string_view>

namespace searle::rheometry::report {

/// A place in a drawing, pixels, y downwards.
struct Pixel {
    double x{};
    double y{};
};

/// A length for an SVG attribute, to 1/100 pixel. Anything not finite becomes 0 and anything huge
/// is cut, so that a drawing is well-formed whatever it is made from.
[[nodiscard]] std::string pixels(double value);

/// Appends ` name="value"`.
void attribute(std::string& out, std::string_view name, double value);
void attribute(std::string& out, std::string_view name, std::string_view value);

/// Appends a straight line of the given class.
void draw_line(std::string& out, Pixel from, Pixel to, std::string_view css_class);

/// Path data through the points; a point that is not finite leaves a hole.
[[nodiscard]] std::string path_through(std::span<const Pixel> points, bool closed = false);

} // namespace searle::rheometry::report
