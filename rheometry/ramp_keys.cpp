#include "casefile/reading.hpp"
#include "rheometry/protocol_keys.hpp"

#include <cstdint>

namespace searle::rheometry {
namespace {

template <class Target>
casefile::Key& speed_key(casefile::Keys<Target>& keys, const char* name,
                         casefile::Quantity Target::*member) {
    return keys.key(name, member)
        .measures({casefile::shear_rate, casefile::angular_velocity, casefile::speed})
        .at_least("-1e9")
        .at_most("1e9");
}

template <class Target>
void add_duration_and_points(casefile::Keys<Target>& keys, const char* duration_example,
                             const char* points_example) {
    keys.key("duration", &Target::duration)
        .measures(casefile::duration)
        .above("0 s")
        .at_most("1e9 s")
        .required()
        .example(duration_example)
        .says("Time that it takes.");
    keys.key("points", &Target::points)
        .is_integer()
        .at_least("1")
        .at_most("1000000")
        .example(points_example)
        .says("Rows of the result, evenly spaced in time, the last one at the end.");
}

} // namespace

casefile::Keys<RampAsWritten> ramp_keys() {
    casefile::Keys<RampAsWritten> keys;
    speed_key(keys, "from", &RampAsWritten::from)
        .example("0 1/s")
        .says("Speed at the start: a shear rate, an angular velocity, or the box's wall speed.");
    speed_key(keys, "to", &RampAsWritten::to)
        .required()
        .example("100 1/s")
        .says("Speed at the end; a negative one turns the other way.");
    add_duration_and_points(keys, "35 s", "100");
    keys.choice<StartState RampAsWritten::*, StartState>(
            "start", &RampAsWritten::start,
            {{"steady", StartState::steady, "the flow is steady at `from` before the ramp"},
             {"rest", StartState::rest, "the drive jumps from rest to `from`"}})
        .example("steady")
        .says("The fluid before a ramp that starts at a speed.");
    keys.check([](const RampAsWritten& ramp, casefile::Findings& findings) {
        if (ramp.from.value == 0.0 && ramp.to.value == 0.0)
            findings.contradiction({"to", "from"}, "nothing moves: both speeds are 0",
                                   "a speed other than 0 at one end");
    });
    return keys;
}

casefile::Keys<SegmentsAsWritten> segments_keys() {
    casefile::Keys<SegmentAsWritten> segment;
    speed_key(segment, "to", &SegmentAsWritten::to)
        .required()
        .example("100 1/s")
        .says("Speed at the end of the piece; it starts where the one before ended.");
    add_duration_and_points(segment, "35 s", "50");

    casefile::Keys<SegmentsAsWritten> keys;
    casefile::Key& list = keys.tables("segments", &SegmentsAsWritten::segments, segment);
    list.required().says("The pieces, each a [[protocol.segments]].");
    list.takes.most_items = 10000;
    keys.check([](const SegmentsAsWritten& written, casefile::Findings& findings) {
        std::int64_t rows = 0;
        bool moves = false;
        for (const SegmentAsWritten& segment_read : written.segments) {
            rows += segment_read.points;
            moves = moves || segment_read.to.value != 0.0;
        }
        if (rows > most_rows)
            findings.contradiction({"segments"}, "the points of all segments are too many",
                                   "at most 1000000 together");
        if (!moves)
            findings.contradiction({"segments"}, "nothing moves: all speeds are 0",
                                   "a speed other than 0");
    });
    return keys;
}

} // namespace searle::rheometry
