#include "rheometry/report/svg_path.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace searle::rheometry::report {

namespace {

void append_pixels(std::string& out, double value) {
    constexpr double largest = 1e6;
    const double kept = std::isfinite(value) ? std::clamp(value, -largest, largest) : 0.0;
    long hundredths = std::lround(kept * 100.0);
    if (hundredths < 0) {
        out += '-';
        hundredths = -hundredths;
    }
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, hundredths / 100).ptr;
    out.append(digits, end);
    const long rest = hundredths % 100;
    if (rest == 0) {
        return;
    }
    out += '.';
    out += static_cast<char>('0' + rest / 10);
    if (rest % 10 != 0) {
        out += static_cast<char>('0' + rest % 10);
    }
}

} // namespace

std::string pixels(double value) {
    std::string out;
    append_pixels(out, value);
    return out;
}

void attribute(std::string& out, std::string_view name, double value) {
    out += ' ';
    out += name;
    out += "=\"";
    append_pixels(out, value);
    out += '"';
}

void attribute(std::string& out, std::string_view name, std::string_view value) {
    out += ' ';
    out += name;
    out += "=\"";
    out += value;
    out += '"';
}

void draw_line(std::string& out, Pixel from, Pixel to, std::string_view css_class) {
    out += "<line";
    attribute(out, "class", css_class);
    attribute(out, "x1", from.x);
    attribute(out, "y1", from.y);
    attribute(out, "x2", to.x);
    attribute(out, "y2", to.y);
    out += "/>";
}

std::string path_through(std::span<const Pixel> points, bool closed) {
    std::string out;
    out.reserve(points.size() * 13);
    bool pen_down = false;
    for (const Pixel& point : points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
            pen_down = false;
            continue;
        }
        out += pen_down ? 'L' : 'M';
        append_pixels(out, point.x);
        out += ' ';
        append_pixels(out, point.y);
        pen_down = true;
    }
    if (closed && !out.empty()) {
        out += 'Z';
    }
    return out;
}

} // namespace searle::rheometry::report
