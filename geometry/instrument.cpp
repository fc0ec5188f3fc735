#include "geometry/instrument.hpp"

namespace searle::geometry {

std::string_view name_of(const Instrument& instrument) {
    struct Name {
        std::string_view operator()(const ConcentricCylinders&) const { return "single-gap"; }
        std::string_view operator()(const DoubleGap&) const { return "double-gap"; }
        std::string_view operator()(const DinBob&) const { return "din-bob"; }
        std::string_view operator()(const Box&) const { return "box"; }
    };
    return std::visit(Name{}, instrument);
}

bool rotates(const Instrument& instrument) { return !std::holds_alternative<Box>(instrument); }

} // namespace searle::geometry
