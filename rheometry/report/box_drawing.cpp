#include "rheometry/report/box_drawing.hpp"

#include "rheometry/report/half_section.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace searle::rheometry::report {

Drafting draw_box(const geometry::Box& instrument, bool periodic) {
    constexpr double drawing_width = 480.0;
    constexpr double most_length = 250.0;
    constexpr double most_height = 200.0;
    constexpr double least = 70.0;
    constexpr double plate = 14.0;
    constexpr double left = 66.0;
    constexpr double oblique = 0.35; // pixels right and up per pixel of depth, each

    const double common = std::min({most_length / instrument.length, most_height / instrument.gap,
                                    most_length / instrument.width});
    const auto drawn = [&](double metres, double most) {
        return std::clamp(common * metres, least, most);
    };
    const double length = drawn(instrument.length, most_length);
    const double gap = drawn(instrument.gap, most_height);
    const double depth = drawn(instrument.width, most_length) * oblique;
    const bool to_scale = length == common * instrument.length && gap == common * instrument.gap &&
                          depth == common * instrument.width * oblique;

    const double front_top = 66.0 + plate + depth;
    const double front_bottom = front_top + gap;
    const double right = left + length;
    const double height = front_bottom + plate + 78.0;
    Drafting drawing{drawing_width, height};

    // The fluid's front, side and the hidden edges behind it.
    const std::array<Pixel, 4> front{
        {{left, front_top}, {right, front_top}, {right, front_bottom}, {left, front_bottom}}};
    const std::array<Pixel, 4> side{{{right, front_top},
                                     {right + depth, front_top - depth},
                                     {right + depth, front_bottom - depth},
                                     {right, front_bottom}}};

    const auto draw_plate = [&](double top, Material material) {
        const std::array<Pixel, 6> body{{{left, top},
                                         {left + depth, top - depth},
                                         {right + depth, top - depth},
                                         {right + depth, top - depth + plate},
                                         {right, top + plate},
                                         {left, top + plate}}};
        if (periodic) {
            drawing.path(path_through(body, true), "dimension");
            return;
        }
        drawing.path(path_through(body, true), "paper");
        drawing.region(body, material);
        drawing.outline(body, true);
        const std::array<Pixel, 3> near_edge{
            {{left, top}, {right, top}, {right + depth, top - depth}}};
        drawing.outline(near_edge);
        drawing.line({right, top}, {right, top + plate}, "outline");
    };
    draw_plate(front_bottom, Material::fixed);
    drawing.region(front, Material::fluid);
    drawing.region(side, Material::fluid);
    drawing.outline(front, true);
    drawing.outline(side, true);
    draw_plate(front_top - plate, Material::rotor);

    constexpr int arrows = 6;
    const double reach = std::min(110.0, 0.5 * length);
    const double start = left + 0.12 * length;
    drawing.line({start, front_top}, {start, front_bottom}, "velocity");
    drawing.line({start + reach, front_top}, {start, front_bottom}, "velocity");
    for (int k = 1; k < arrows; ++k) {
        const double share = static_cast<double>(k) / arrows;
        const double y = front_bottom - share * gap;
        drawing.line({start, y}, {start + share * reach, y}, "velocity");
        drawing.arrow_head({start + share * reach, y}, 0.0, "velocity-head");
    }
    drawing.text({start + reach * 0.75 + 16.0, front_top + 0.45 * gap},
                 RichText{}.italic("v").upright("(").italic("y").upright(")"));

    const double speed_y = front_top - plate - depth - 14.0;
    constexpr double speed_label = 88.0 + 165.0; // the arrow and its text
    const double speed_x =
        std::min(left + depth + 0.5 * length - 40.0, drawing_width - 6.0 - speed_label);
    drawing.line({speed_x, speed_y}, {speed_x + 80.0, speed_y}, "velocity");
    drawing.arrow_head({speed_x + 80.0, speed_y}, 0.0, "velocity-head");
    drawing.text({speed_x + 88.0, speed_y + 4.0},
                 periodic
                     ? RichText{"the image above moves with "}.italic("U")
                     : RichText{"moving wall, "}.italic("U").upright(" and force ").italic("F"));
    constexpr double wall_label = 64.0;
    drawing.leader({right + 0.9 * depth, front_bottom - 0.9 * depth + 0.5 * plate},
                   {std::min(right + depth + 16.0, drawing_width - 6.0 - wall_label),
                    front_bottom - depth - 0.25 * gap},
                   RichText{periodic ? "image below" : "fixed wall"});

    drawing.vertical_dimension({left, front_top}, {left, front_bottom}, left - 24.0,
                               length_text("h", "", instrument.gap));
    drawing.horizontal_dimension({left, front_bottom + plate}, {right, front_bottom + plate},
                                 front_bottom + plate + 30.0,
                                 length_text("\u2113", "", instrument.length));
    const Pixel near_corner{right, front_bottom + plate};
    const Pixel far_corner{right + depth, front_bottom + plate - depth};
    constexpr double aside = 16.0;
    drawing.line(near_corner, {near_corner.x + aside + 3.0, near_corner.y}, "extension");
    drawing.line(far_corner, {far_corner.x + aside + 3.0, far_corner.y}, "extension");
    drawing.line({near_corner.x + aside, near_corner.y}, {far_corner.x + aside, far_corner.y},
                 "dimension");
    drawing.arrow_head({near_corner.x + aside, near_corner.y}, 135.0);
    drawing.arrow_head({far_corner.x + aside, far_corner.y}, -45.0);
    drawing.text({0.5 * (near_corner.x + far_corner.x) + aside + 10.0,
                  0.5 * (near_corner.y + far_corner.y) + 12.0},
                 length_text("b", "", instrument.width));
    drawing.text({drawing_width - 6.0, height - 8.0},
                 RichText{to_scale ? "oblique view, depth drawn at half size"
                                   : "oblique view, not to scale"},
                 Anchor::end, "halo soft small");
    return drawing;
}

} // namespace searle::rheometry::report
