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
    keys.check([](const DoubleGap& gap, casefile::Findings& findings) {
        const auto& [post, inside, outside, cup] = gap.radii;
        if (!(post < inside && inside < outside && outside < cup))
            findings.contradiction({"radii"}, "the radii do not increase",
                                   "post < rotor inside < rotor outside < cup");
    });
    return keys;
}

} // namespace searle::geometry
