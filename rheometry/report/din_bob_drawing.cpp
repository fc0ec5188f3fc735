#include "rheometry/report/din_bob_drawing.hpp"

#include "rheometry/report/half_section.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace searle::rheometry::report {

namespace {

constexpr double width = 480.0;
constexpr double axis_x = 56.0;
constexpr double surface_y = 92.0;
constexpr double most_radius = 150.0;
constexpr double most_height = 330.0;
constexpr double wall = 13.0;
constexpr double rim = 18.0; // drawn height of the cup above the free surface
constexpr double shaft_top = 58.0;

} // namespace

Drafting draw_din_bob(const geometry::DinBob& instrument) {
    const double radius = instrument.bob_radius;
    const double length = instrument.height();
    const double below = instrument.bottom_ratio * radius;
    const double above = instrument.top_ratio * radius;
    const double shaft = instrument.shaft_ratio * radius;
    const double cup = instrument.cup_radius;
    const double total = below + length + above;

    SectionScale scale;
    scale.axis_x = axis_x;
    scale.per_metre_r = std::min(most_radius / cup, most_height / total);
    scale.per_metre_z = scale.per_metre_r;
    scale.floor_y = surface_y + (length + above) * scale.per_metre_z; // z = 0: the lower edge

    const Pixel tip = scale.at(0.0, -instrument.cone_height());
    const Pixel lower_edge = scale.at(radius, 0.0);
    const Pixel upper_edge = scale.at(radius, length);
    const Pixel shaft_foot = scale.at(shaft, length);
    const Pixel cup_floor = scale.at(cup, -below);
    const double cup_outside = cup_floor.x + wall;
    const double height = std::max(360.0, cup_floor.y + wall + 92.0);
    Drafting drawing{width, height};

    drawing.rectangle({axis_x, surface_y}, cup_floor, Material::fluid);
    const std::array<Pixel, 6> body{
        {{axis_x, shaft_top}, {shaft_foot.x, shaft_top}, shaft_foot, upper_edge, lower_edge, tip}};
    drawing.path("M" + pixels(axis_x) + " " + pixels(shaft_top) + "H" + pixels(shaft_foot.x) + "V" +
                     pixels(shaft_foot.y) + "H" + pixels(upper_edge.x) + "V" +
                     pixels(lower_edge.y) + "L" + pixels(tip.x) + " " + pixels(tip.y) + "Z",
                 "paper");
    drawing.region(body, Material::rotor);
    drawing.outline(std::span{body}.subspan(1));
    drawing.break_line(axis_x, shaft_foot.x, shaft_top);
    const std::array<Pixel, 6> vessel{{{cup_floor.x, surface_y - rim},
                                       {cup_outside, surface_y - rim},
                                       {cup_outside, cup_floor.y + wall},
                                       {axis_x, cup_floor.y + wall},
                                       {axis_x, cup_floor.y},
                                       cup_floor}};
    drawing.region(vessel, Material::fixed);
    const std::array<Pixel, 5> vessel_edge{
        {{axis_x, cup_floor.y}, cup_floor, vessel[0], vessel[1], vessel[2]}};
    drawing.outline(vessel_edge);
    drawing.line({shaft_foot.x, surface_y}, {cup_floor.x, surface_y}, "hairline");
    drawing.free_surface(0.5 * (shaft_foot.x + cup_floor.x), surface_y);
    drawing.axis(axis_x, 12.0, cup_floor.y + wall + 16.0);
    RichText omega;
    omega.italic("\u03c9");
    drawing.turning_arrow({axis_x, 26.0}, 18.0, omega);

    drawing.horizontal_dimension({axis_x, shaft_top + 4.0}, {shaft_foot.x, shaft_top + 4.0},
                                 shaft_top - 8.0, length_text("R", "shaft", shaft));
    const double first_row = cup_floor.y + wall + 26.0;
    const Pixel axis_foot{axis_x, cup_floor.y + wall + 4.0};
    drawing.horizontal_dimension(axis_foot, lower_edge, first_row, RichText{});
    drawing.text({cup_outside + 6.0, first_row + 4.0}, length_text("R", "bob", radius));
    drawing.horizontal_dimension(axis_foot, cup_floor, first_row + 24.0, RichText{});
    drawing.text({cup_outside + 6.0, first_row + 28.0}, length_text("R", "cup", cup));
    const double chain = cup_outside + 26.0;
    drawing.vertical_dimension({shaft_foot.x, surface_y}, upper_edge, chain, length_text(above));
    drawing.vertical_dimension(upper_edge, lower_edge, chain, length_text("L", "", length));
    drawing.vertical_dimension(lower_edge, cup_floor, chain, length_text(below));

    const double half_angle = 0.5 * instrument.cone_angle * 180.0 / std::numbers::pi;
    const double arc_radius = std::clamp(0.75 * (lower_edge.x - axis_x), 20.0, 44.0);
    const double flank = half_angle * std::numbers::pi / 180.0;
    drawing.line(tip,
                 {tip.x - (arc_radius + 6.0) * std::sin(flank),
                  tip.y - (arc_radius + 6.0) * std::cos(flank)},
                 "extension");
    drawing.arc(tip, arc_radius, -90.0 - half_angle, -90.0 + half_angle, "dimension");
    drawing.text({axis_x + 3.0, tip.y - arc_radius - 5.0},
                 RichText{significant(2.0 * half_angle, 4) + "\u00b0"});

    const double labels = chain + 40.0;
    const Pixel bob = scale.at(0.55 * radius, 0.55 * length);
    drawing.vertical_text({bob.x + 4.0, bob.y}, RichText{"bob, turns"});
    drawing.leader({cup_outside - 0.5 * wall, surface_y - 8.0}, {labels, surface_y - 14.0},
                   RichText{"cup, fixed"});
    drawing.leader({0.25 * shaft_foot.x + 0.75 * cup_floor.x, surface_y},
                   {labels, surface_y + 12.0}, RichText{"free surface"});
    drawing.leader({cup_outside - 0.6 * wall, cup_floor.y + 0.5 * wall},
                   {labels, cup_floor.y + 14.0}, RichText{"cup floor"});

    const std::array<Layer, 3> layers{{{0.0, radius, Material::rotor},
                                       {radius, cup, Material::fluid},
                                       {cup, cup, Material::fixed}}};
    if (instrument.gap() * scale.per_metre_r < 44.0) {
        const double z = 0.8 * length;
        magnify_gap(drawing, scale, layers, z, {width - 86.0, scale.at(cup, z).y + 40.0}, 72.0);
    } else {
        const Pixel middle = scale.at(radius, 0.5 * length);
        drawing.horizontal_dimension(middle, {cup_floor.x, middle.y}, middle.y,
                                     length_text(instrument.gap()));
    }
    drawing.text({width - 6.0, height - 8.0}, RichText{"vertical half-section, to scale"},
                 Anchor::end, "halo soft small");
    return drawing;
}

} // namespace searle::rheometry::report
