#include "rheometry/protocol_keys.hpp"

#include <cmath>

namespace searle::rheometry {
namespace {

ProtocolSpeed speed_of(const casefile::Quantity& written) {
    const bool is_rate = written.kind == static_cast<std::size_t>(WrittenSpeedKind::shear_rate);
    return {written.value, is_rate ? SpeedKind::shear_rate : SpeedKind::drive};
}

void append(std::vector<ProtocolSpeed>& speeds, const SpeedSeries& series, SpeedKind kind) {
    for (const double value : series.range ? speeds_of(*series.range) : series.listed)
        speeds.push_back({value, kind});
}

struct Finish {
    Protocol operator()(const RampAsWritten& ramp) const {
        return {Ramp{speed_of(ramp.from), speed_of(ramp.to), ramp.duration, ramp.points},
                ramp.start};
    }
    Protocol operator()(const StepsAsWritten& written) const {
        Steps steps{{}, written.hold, written.hold_strain, written.discard_strain};
        append(steps.speeds, written.shear_rates, SpeedKind::shear_rate);
        append(steps.speeds, written.angular_velocities, SpeedKind::drive);
        append(steps.speeds, written.wall_speeds, SpeedKind::drive);
        return {std::move(steps)};
    }
    Protocol operator()(const SegmentsAsWritten& written) const {
        Segments segments;
        for (const SegmentAsWritten& segment : written.segments)
            segments.segments.push_back({speed_of(segment.to), segment.duration, segment.points});
        return {std::move(segments)};
    }
};

} // namespace

std::vector<double> speeds_of(const SpeedRange& range) {
    const int count = range.count;
    std::vector<double> speeds(static_cast<std::size_t>(count), range.from);
    for (int at = 1; at < count; ++at) {
        const double share = static_cast<double>(at) / (count - 1);
        speeds[static_cast<std::size_t>(at)] =
            range.spacing == Spacing::logarithmic
                ? range.from * std::pow(range.to / range.from, share)
                : range.from + share * (range.to - range.from);
    }
    speeds.back() = range.to;
    return speeds;
}

casefile::Keys<ProtocolAsWritten> protocol_keys() {
    const auto program = &ProtocolAsWritten::program;
    casefile::Keys<ProtocolAsWritten> keys;
    keys.selector("type", "How the speed of the drive changes with time.");
    keys.alternative("ramp", "linear from one speed to another", program, ramp_keys());
    keys.alternative("steps", "one row for each of a list of speeds", program, steps_keys());
    keys.alternative("segments", "straight pieces, one after the other, the first from rest",
                     program, segments_keys());
    return keys;
}

Protocol protocol_of(const ProtocolAsWritten& written) {
    return std::visit(Finish{}, written.program);
}

} // namespace searle::rheometry
