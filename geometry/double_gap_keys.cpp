#include "casefile/reading.hpp"
#include "geometry/instrument_keys.hpp"

namespace searle::geometry {

casefile::Keys<DoubleGap> double_gap_keys() {
    casefile::Keys<DoubleGap> keys;
    keys.key("radii", &DoubleGap::radii)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .is_list(4, 4)
        .required()
        .example(R"(["20 mm", "20.38 mm", "21.96 mm", "22.38 mm"])")
        .says("Radii of the post, the rotor inside and outside, and the cup; increasing.");
    keys.key("height", &DoubleGap::height)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("55 mm")
        .says("Wetted length of the rotor that the torque is for.");
    keys.key("ends", &DoubleGap::ends)
        .is_boolean()
        .example("false")
        .not_in_new()
        .says("Solve the fluid under the rotor too, not only a slice of the gaps.");
    keys.key("bottom_gap", &DoubleGap::bottom_gap)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .example("0 mm")
        .not_in_new()
        .says("With ends = true: from the rotor's lower edge to the floor; needed there.");
    keys.check([](const DoubleGap& gap, casefile::Findings& findings) {
        const auto& [post, inside, outside, cup] = gap.radii;
        if (!(post < inside && inside < outside && outside < cup))
            findings.contradiction({"radii"}, "the radii do not increase",
                                   "post < rotor inside < rotor outside < cup");
        if (gap.ends && !(gap.bottom_gap > 0.0))
            findings.contradiction({"bottom_gap", "ends"}, "real ends need a gap below the rotor",
                                   "bottom_gap above 0, such as \"5 mm\"");
        if (!gap.ends && gap.bottom_gap > 0.0)
            findings.contradiction({"bottom_gap", "ends"},
                                   "a slice without ends has no fluid there",
                                   "ends = true beside it");
    });
    return keys;
}

} // namespace searle::geometry
