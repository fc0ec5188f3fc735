#include "rheometry/report/number_text.hpp"
#include "rheometry/report/property_rows.hpp"

#include <numbers>
#include <variant>

namespace searle::rheometry::report {

namespace {

constexpr int digits = 6;

std::string volume_text(double cubic_metres) {
    return significant(cubic_metres * 1e6, 5) + "\u00a0mL";
}

class RowWriter {
public:
    explicit RowWriter(const ReportInput& input) : input_{input} {}

    void length(std::string name, std::string symbol, double metres, std::string_view key = {}) {
        add(std::move(name), std::move(symbol), quantity_text(metres, "m", digits), key);
    }
    void number(std::string name, std::string symbol, double value, std::string_view key = {}) {
        add(std::move(name), std::move(symbol), significant(value, digits), key);
    }
    void add(std::string name, std::string symbol, std::string value, std::string_view key = {}) {
        const std::string note = key.empty() ? "" : source_note(input_, key);
        rows.push_back({std::move(name), std::move(symbol), std::move(value) + note});
    }

    std::vector<PropertyRow> rows;

private:
    const ReportInput& input_;
};

struct Describe {
    RowWriter& out;
    bool periodic; ///< a box without walls

    void operator()(const geometry::ConcentricCylinders& it) const {
        out.length("Bob radius", "<i>R</i><sub>bob</sub>", it.bob_radius, "geometry.bob_radius");
        out.length("Cup radius", "<i>R</i><sub>cup</sub>", it.cup_radius, "geometry.cup_radius");
        out.length("Wetted length", "<i>L</i>", it.height, "geometry.height");
        out.length("Gap", "<i>d</i>", it.gap());
        out.number("Radius ratio", "<i>\u03b4</i> = <i>R</i><sub>cup</sub>/<i>R</i><sub>bob</sub>",
                   it.radius_ratio());
        if (it.offset > 0.0)
            out.length("Offset of the bob's axis from the cup's", "<i>e</i>", it.offset,
                       "geometry.offset");
        const double area = std::numbers::pi * it.gap() * (it.cup_radius + it.bob_radius);
        out.add("Volume in the gap", "", volume_text(area * it.height));
        if (it.ends) {
            out.length("Gap below the bob", "", it.bottom_gap, "geometry.bottom_gap");
            if (it.top_gap > 0.0) {
                out.length("Fluid above the bob", "", it.top_gap, "geometry.top_gap");
                out.length("Shaft radius", "", it.shaft_radius, "geometry.shaft_radius");
            }
        }
    }

    void operator()(const geometry::DoubleGap& it) const {
        const auto& [post, inside, outside, cup] = it.radii;
        out.length("Post radius", "<i>R</i><sub>1</sub>", post, "geometry.radii");
        out.length("Rotor radius, inside", "<i>R</i><sub>2</sub>", inside, "geometry.radii");
        out.length("Rotor radius, outside", "<i>R</i><sub>3</sub>", outside, "geometry.radii");
        out.length("Cup radius", "<i>R</i><sub>4</sub>", cup, "geometry.radii");
        out.length("Wetted length", "<i>L</i>", it.height, "geometry.height");
        out.length("Inner gap", "<i>R</i><sub>2</sub> \u2212 <i>R</i><sub>1</sub>", it.inner_gap());
        out.length("Outer gap", "<i>R</i><sub>4</sub> \u2212 <i>R</i><sub>3</sub>", it.outer_gap());
        out.number("Radius ratio, inner gap", "<i>R</i><sub>2</sub>/<i>R</i><sub>1</sub>",
                   inside / post);
        out.number("Radius ratio, outer gap",
                   "<i>\u03b4</i> = <i>R</i><sub>4</sub>/<i>R</i><sub>3</sub>", it.radius_ratio());
        const double area = std::numbers::pi *
                            (it.inner_gap() * (inside + post) + it.outer_gap() * (cup + outside));
        out.add("Volume in the gaps", "", volume_text(area * it.height));
        if (it.ends) {
            out.length("Gap below the rotor", "", it.bottom_gap, "geometry.bottom_gap");
        }
    }

    void operator()(const geometry::DinBob& it) const {
        out.length("Bob radius", "<i>R</i><sub>bob</sub>", it.bob_radius, "geometry.bob_radius");
        out.length("Cup radius", "<i>R</i><sub>cup</sub>", it.cup_radius, "geometry.cup_radius");
        out.number("Radius ratio", "<i>\u03b4</i> = <i>R</i><sub>cup</sub>/<i>R</i><sub>bob</sub>",
                   it.radius_ratio(), "geometry.radius_ratio");
        out.length("Gap", "<i>d</i>", it.gap());
        out.length("Length of the cylinder", "<i>L</i>", it.height(), "geometry.length_ratio");
        out.length("Cylinder\u2019s lower edge to cup floor", "", it.bottom_ratio * it.bob_radius,
                   "geometry.bottom_ratio");
        out.length("Cone\u2019s tip to cup floor", "", it.tip_clearance());
        out.length("Bob\u2019s top face to free surface", "", it.top_ratio * it.bob_radius,
                   "geometry.top_ratio");
        out.length("Shaft radius", "<i>R</i><sub>shaft</sub>", it.shaft_ratio * it.bob_radius,
                   "geometry.shaft_ratio");
        out.add("Apex angle of the cone", "",
                significant(it.cone_angle * 180.0 / std::numbers::pi, digits) + "\u00b0",
                "geometry.cone_angle");
        const double cube = it.bob_radius * it.bob_radius * it.bob_radius;
        out.add("Filling volume", "",
                volume_text(it.fill_volume()) + " = " + significant(it.fill_volume() / cube, 5) +
                    " <i>R</i><sub>bob</sub>\u00b3");
    }

    void operator()(const geometry::Box& it) const {
        out.length("Gap", "<i>h</i>", it.gap, "geometry.gap");
        out.length("Length along the flow", "<i>\u2113</i>", it.length, "geometry.length");
        out.length("Width", "<i>b</i>", it.width, "geometry.width");
        const double area = it.wall_area();
        out.add(periodic ? "Area of the top" : "Area of the moving wall", "<i>A</i>",
                area >= 1e-8 ? significant(area * 1e6, digits) + "\u00a0mm\u00b2"
                             : significant(area * 1e12, digits) + "\u00a0\u00b5m\u00b2");
    }
};

} // namespace

std::vector<PropertyRow> instrument_rows(const ReportInput& input) {
    RowWriter writer{input};
    writer.add("Type", "", std::string{geometry::name_of(input.instrument)}, "geometry.type");
    std::visit(Describe{writer, is_periodic(input)}, input.instrument);
    return std::move(writer.rows);
}

std::string_view instrument_phrase(const ReportInput& input) {
    if (is_periodic(input))
        return "a box without walls";
    struct Phrase {
        std::string_view operator()(const geometry::ConcentricCylinders&) const {
            return "single-gap concentric cylinders";
        }
        std::string_view operator()(const geometry::DoubleGap&) const { return "a double gap"; }
        std::string_view operator()(const geometry::DinBob&) const {
            return "a DIN bob in its cup";
        }
        std::string_view operator()(const geometry::Box&) const {
            return "a box with one moving wall";
        }
    };
    return std::visit(Phrase{}, input.instrument);
}

} // namespace searle::rheometry::report
