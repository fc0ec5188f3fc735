#include "rheometry/report/geometry_drawing.hpp"

#include "rheometry/report/box_drawing.hpp"
#include "rheometry/report/cylinder_drawing.hpp"
#include "rheometry/report/din_bob_drawing.hpp"

#include <variant>

namespace searle::rheometry::report {

namespace {

struct Draw {
    bool periodic;
    Drafting operator()(const geometry::ConcentricCylinders& it) const {
        return draw_single_gap(it);
    }
    Drafting operator()(const geometry::DoubleGap& it) const { return draw_double_gap(it); }
    Drafting operator()(const geometry::DinBob& it) const { return draw_din_bob(it); }
    Drafting operator()(const geometry::Box& it) const { return draw_box(it, periodic); }
};

std::string drawn(const geometry::Instrument& instrument, bool periodic, bool as_file) {
    return std::visit(Draw{periodic}, instrument)
        .svg("Dimensioned drawing of the instrument", as_file);
}

} // namespace

std::string geometry_drawing(const geometry::Instrument& instrument) {
    return drawn(instrument, false, true);
}

std::string geometry_drawing_for_page(const geometry::Instrument& instrument, bool periodic) {
    return drawn(instrument, periodic, false);
}

} // namespace searle::rheometry::report
