#include "rheometry/report/cylinder_drawing.hpp"

#include "rheometry/report/half_section.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace searle::rheometry::report {

namespace {

constexpr double width = 480.0;
constexpr double axis_x = 40.0;
constexpr double top_y = 84.0;        // upper end of the wetted length
constexpr double most_radius = 172.0; // pixels for the cup's radius
constexpr double most_height = 270.0;
constexpr double wall = 14.0;     // drawn thickness of the cup
constexpr double overhang = 20.0; // drawn length beyond the wetted length
constexpr double row_height = 24.0;
constexpr double magnified_at = 0.8;      // share of the height at which the gap is magnified
constexpr double widest_plain_gap = 44.0; // pixels from which a gap needs no magnifier

// One scale for both directions where the proportions allow it, else the height has its own.
SectionScale scale_for(double cup_radius, double height) {
    constexpr double least_radius = 70.0;
    constexpr double least_height = 80.0;
    const double common = std::min(most_radius / cup_radius, most_height / height);
    SectionScale scale;
    scale.axis_x = axis_x;
    scale.per_metre_r = std::max(common, least_radius / cup_radius);
    scale.per_metre_z = std::max(common, least_height / height);
    if (!scale.to_scale()) {
        scale.per_metre_r = std::min(scale.per_metre_r, most_radius / cup_radius);
        scale.per_metre_z = std::min(scale.per_metre_z, most_height / height);
    }
    scale.floor_y = top_y + height * scale.per_metre_z;
    return scale;
}

double drawing_height(const SectionScale& scale, double dimension_rows) {
    return std::max(330.0, scale.floor_y + overhang + row_height * dimension_rows + 46.0);
}

// Bodies beyond the wetted length, the limits of that length, the axis and the height.
void draw_cylinders(Drafting& drawing, const SectionScale& scale, std::span<const Layer> layers,
                    double height) {
    const double above = top_y - overhang;
    const double below = scale.floor_y + overhang;
    const double cup_outside = scale.at(layers.back().from, 0.0).x + wall;
    for (const Layer& layer : layers) {
        const bool is_fluid = layer.material == Material::fluid;
        const bool is_cup = &layer == &layers.back();
        const double left = scale.at(layer.from, 0.0).x;
        const double right = is_cup ? cup_outside : scale.at(layer.to, 0.0).x;
        drawing.rectangle({left, is_fluid ? top_y : above},
                          {right, is_fluid ? scale.floor_y : below}, layer.material);
        if (is_fluid) {
            continue;
        }
        drawing.break_line(left, right, above);
        drawing.break_line(left, right, below);
        if (left > scale.axis_x) {
            const std::array<Pixel, 2> edge{{{left, above}, {left, below}}};
            drawing.outline(edge);
        }
        const std::array<Pixel, 2> edge{{{right, above}, {right, below}}};
        drawing.outline(edge);
    }
    drawing.line({scale.axis_x, top_y}, {cup_outside, top_y}, "limit");
    drawing.line({scale.axis_x, scale.floor_y}, {cup_outside, scale.floor_y}, "limit");
    drawing.axis(scale.axis_x, 26.0, below + 14.0);
    RichText omega;
    omega.italic("\u03c9");
    drawing.turning_arrow({scale.axis_x, 42.0}, 20.0, omega);
    drawing.vertical_dimension({cup_outside, top_y}, {cup_outside, scale.floor_y},
                               cup_outside + 24.0, length_text("L", "", height));
}

void draw_radius(Drafting& drawing, const SectionScale& scale, double radius, double cup_radius,
                 int row, const RichText& text) {
    const double below = scale.floor_y + overhang;
    const double along = below + row_height * (row + 1);
    drawing.horizontal_dimension({scale.axis_x, below + 14.0},
                                 {scale.at(radius, 0.0).x, below + 2.0}, along, RichText{});
    drawing.text({scale.at(cup_radius, 0.0).x + wall + 6.0, along + 4.0}, text);
}

void draw_note(Drafting& drawing, const SectionScale& scale, double y, bool ends) {
    const std::string proportions =
        scale.to_scale() ? "to scale" : "height not to the scale of the radii";
    drawing.text({width - 6.0, y - 15.0}, RichText{"vertical half-section, " + proportions},
                 Anchor::end, "halo soft small");
    drawing.text({width - 6.0, y},
                 RichText{ends ? "the model's ends, beyond the dashed lines, are not drawn"
                               : "ends, beyond the dashed lines, are not part of the model"},
                 Anchor::end, "halo soft small");
}

} // namespace

Drafting draw_single_gap(const geometry::ConcentricCylinders& instrument) {
    const SectionScale scale = scale_for(instrument.cup_radius, instrument.height);
    const bool is_eccentric = instrument.offset > 0.0;
    const double height = drawing_height(scale, is_eccentric ? 3.0 : 2.0);
    Drafting drawing{width, height};
    const std::array<Layer, 3> layers{
        {{0.0, instrument.bob_radius, Material::rotor},
         {instrument.bob_radius, instrument.cup_radius, Material::fluid},
         {instrument.cup_radius, instrument.cup_radius, Material::fixed}}};
    draw_cylinders(drawing, scale, layers, instrument.height);
    draw_radius(drawing, scale, instrument.bob_radius, instrument.cup_radius, 0,
                length_text("R", "bob", instrument.bob_radius));
    draw_radius(drawing, scale, instrument.cup_radius, instrument.cup_radius, 1,
                length_text("R", "cup", instrument.cup_radius));

    const Pixel bob = scale.at(0.5 * instrument.bob_radius, 0.5 * instrument.height);
    drawing.vertical_text({bob.x + 4.0, bob.y}, RichText{"bob, turns"});
    const Pixel cup = scale.at(instrument.cup_radius, instrument.height);
    drawing.leader({cup.x + 0.5 * wall, cup.y - 8.0}, {cup.x + wall + 44.0, cup.y - 22.0},
                   RichText{"cup, fixed"});

    const Pixel middle = scale.at(instrument.bob_radius, magnified_at * instrument.height);
    const double gap = instrument.gap() * scale.per_metre_r;
    if (gap < widest_plain_gap) {
        magnify_gap(drawing, scale, layers, magnified_at * instrument.height,
                    {width - 92.0, std::max(190.0, middle.y + 14.0)}, 76.0);
    } else {
        drawing.horizontal_dimension({middle.x, middle.y}, {middle.x + gap, middle.y}, middle.y,
                                     length_text(instrument.gap()));
        const Pixel fluid = scale.at(0.5 * (instrument.bob_radius + instrument.cup_radius),
                                     0.3 * instrument.height);
        drawing.text({fluid.x, fluid.y}, RichText{"fluid"}, Anchor::middle);
    }
    draw_note(drawing, scale, height - 8.0, instrument.ends);
    if (is_eccentric)
        drawing.text({scale.at(instrument.cup_radius, 0.0).x + wall + 6.0,
                      scale.floor_y + overhang + row_height * 3.0 + 4.0},
                     length_text("e", "", instrument.offset)
                         .upright(", bob's axis off the cup's; drawn centred"));
    return drawing;
}

Drafting draw_double_gap(const geometry::DoubleGap& instrument) {
    const auto& radii = instrument.radii;
    const SectionScale scale = scale_for(radii[3], instrument.height);
    const double height = drawing_height(scale, 4.0);
    Drafting drawing{width, height};
    const std::array<Layer, 5> layers{{{0.0, radii[0], Material::fixed},
                                       {radii[0], radii[1], Material::fluid},
                                       {radii[1], radii[2], Material::rotor},
                                       {radii[2], radii[3], Material::fluid},
                                       {radii[3], radii[3], Material::fixed}}};
    draw_cylinders(drawing, scale, layers, instrument.height);
    constexpr std::array<std::string_view, 4> indices{"1", "2", "3", "4"};
    for (std::size_t k = 0; k < radii.size(); ++k) {
        draw_radius(drawing, scale, radii[k], radii[3], static_cast<int>(k),
                    length_text("R", indices[k], radii[k]));
    }
    const Pixel post = scale.at(0.5 * radii[0], 0.5 * instrument.height);
    drawing.vertical_text({post.x + 4.0, post.y}, RichText{"post, fixed"});
    const Pixel cup = scale.at(radii[3], instrument.height);
    drawing.leader({cup.x + 0.5 * wall, cup.y - 8.0}, {cup.x + wall + 44.0, cup.y - 14.0},
                   RichText{"cup, fixed"});
    const Pixel rotor = scale.at(0.5 * (radii[1] + radii[2]), instrument.height);
    drawing.leader({rotor.x, rotor.y - 12.0}, {cup.x + wall + 44.0, cup.y - 40.0},
                   RichText{"rotor, turns"});
    const Pixel middle = scale.at(radii[1], magnified_at * instrument.height);
    magnify_gap(drawing, scale, layers, magnified_at * instrument.height,
                {width - 104.0, std::max(200.0, middle.y + 30.0)}, 88.0);
    draw_note(drawing, scale, height - 8.0, instrument.ends);
    return drawing;
}

} // namespace searle::rheometry::report
