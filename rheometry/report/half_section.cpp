#include "rheometry/report/half_section.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace searle::rheometry::report {

RichText length_text(double metres) { return RichText{quantity_text(metres, "m", 5)}; }

RichText length_text(std::string_view symbol, std::string_view index, double metres) {
    RichText out;
    out.italic(symbol).subscript(index).upright(" = ").append(length_text(metres));
    return out;
}

void magnify_gap(Drafting& drawing, const SectionScale& scale, std::span<const Layer> layers,
                 double z, Pixel centre, double radius) {
    const double inner = layers[1].from;
    const double outer = layers[layers.size() - 2].to;
    const double span = outer - inner;
    const double share = layers.size() > 3 ? 1.45 : 1.0; // part of the circle's width for the span
    const double magnified = share * radius / span;

    const Pixel source = scale.at(0.5 * (inner + outer), z);
    const double ring = std::max(9.0, 0.5 * span * scale.per_metre_r + 6.0);
    const double dx = centre.x - source.x;
    const double dy = centre.y - source.y;
    const double distance = std::hypot(dx, dy);
    drawing.circle(source, ring, "hairline");
    drawing.line({source.x + dx * ring / distance, source.y + dy * ring / distance},
                 {centre.x - dx * radius / distance, centre.y - dy * radius / distance},
                 "hairline");

    drawing.circle(centre, radius, "paper");
    drawing.begin_circle_clip(centre, radius);
    const auto x_of = [&](double r) { return centre.x + (r - 0.5 * (inner + outer)) * magnified; };
    for (std::size_t k = 0; k < layers.size(); ++k) {
        const double left = k == 0 ? centre.x - radius : x_of(layers[k].from);
        const double right = k + 1 == layers.size() ? centre.x + radius : x_of(layers[k].to);
        drawing.rectangle({left, centre.y - radius}, {right, centre.y + radius},
                          layers[k].material);
    }
    for (std::size_t k = 1; k < layers.size(); ++k) {
        const double x = x_of(layers[k].from);
        drawing.line({x, centre.y - radius}, {x, centre.y + radius}, "outline");
    }
    drawing.end_clip();
    drawing.circle(centre, radius, "outline");

    // One below the other, so that neighbouring widths leave room for their texts.
    const std::size_t inside = layers.size() - 2;
    for (std::size_t k = 1; k <= inside; ++k) {
        const double row = inside == 1 ? 0.0 : (static_cast<double>(k) - 2.0) * 34.0;
        const double y = centre.y + row;
        const double left = x_of(layers[k].from);
        const double right = x_of(layers[k].to);
        const RichText width = length_text(layers[k].to - layers[k].from);
        if (right - left >= 26.0) {
            drawing.line({left, y}, {right, y}, "dimension");
            drawing.arrow_head({left, y}, 180.0);
            drawing.arrow_head({right, y}, 0.0);
        } else {
            drawing.line({left - 16.0, y}, {right + 16.0, y}, "dimension");
            drawing.arrow_head({left, y}, 0.0);
            drawing.arrow_head({right, y}, 180.0);
        }
        drawing.text({0.5 * (left + right), y - 6.0}, width, Anchor::middle);
    }
    const double times = magnified / scale.per_metre_r;
    drawing.text({centre.x, centre.y + radius + 16.0},
                 RichText{"gap, magnified " + significant(times, 2) + "\u00d7"}, Anchor::middle,
                 "halo soft");
}

} // namespace searle::rheometry::report
