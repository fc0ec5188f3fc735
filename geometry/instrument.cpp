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

bool has_ends(const Instrument& instrument) {
    return std::visit(
        [](const auto& chosen) {
            using Kind = std::decay_t<decltype(chosen)>;
            if constexpr (std::is_same_v<Kind, DinBob>) {
                return true;
            } else if constexpr (std::is_same_v<Kind, Box>) {
                return false;
            } else {
                return chosen.ends;
            }
        },
        instrument);
}

bool is_eccentric(const Instrument& instrument) {
    const auto* gap = std::get_if<ConcentricCylinders>(&instrument);
    return gap != nullptr && gap->offset > 0.0;
}

} // namespace searle::geometry
