#include "app/protocol_phrase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace searle::app {
namespace {

using rheometry::ProtocolSpeed;
using rheometry::SpeedKind;

std::string_view unit_of(SpeedKind kind, bool turning) {
    return kind == SpeedKind::shear_rate ? "1/s" : turning ? "rad/s" : "m/s";
}

std::string with_unit(const ProtocolSpeed& speed, bool turning) {
    return fmt::format("{:.6g} {}", speed.value, unit_of(speed.kind, turning));
}

std::string from_to(const ProtocolSpeed& from, const ProtocolSpeed& to, bool turning) {
    return from.kind == to.kind
               ? fmt::format("from {:.6g} to {}", from.value, with_unit(to, turning))
               : fmt::format("from {} to {}", with_unit(from, turning), with_unit(to, turning));
}

struct Phrase {
    bool turning;
    rheometry::StartState start;

    std::string operator()(const rheometry::Ramp& ramp) const {
        const bool jumps = start == rheometry::StartState::rest && ramp.from.value != 0.0;
        return fmt::format("ramp {} in {:.6g} s, {} points{}", from_to(ramp.from, ramp.to, turning),
                           ramp.duration, ramp.points,
                           jumps ? ", started by a jump from rest" : "");
    }
    std::string operator()(const rheometry::Steps& steps) const {
        const std::string hold =
            steps.hold ? fmt::format("held for {:.6g} s each", *steps.hold)
            : steps.hold_strain
                ? fmt::format("held for a strain of {:.6g} each", *steps.hold_strain)
                : "each until steady";
        if (steps.speeds.size() == 1)
            return fmt::format("one speed, {}, {}", with_unit(steps.speeds.front(), turning), hold);
        return fmt::format("{} speeds {}, {}", steps.speeds.size(),
                           from_to(steps.speeds.front(), steps.speeds.back(), turning), hold);
    }
    std::string operator()(const rheometry::Segments& segments) const {
        std::string text = "from rest";
        for (const rheometry::Segment& segment : segments.segments)
            text += fmt::format(", to {} in {:.6g} s", with_unit(segment.to, turning),
                                segment.duration);
        return text;
    }
};

} // namespace

std::string protocol_phrase(const rheometry::Protocol& protocol, bool turning) {
    return std::visit(Phrase{turning, protocol.start}, protocol.program);
}

} // namespace searle::app
