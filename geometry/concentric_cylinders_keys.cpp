#include "casefile/reading.hpp"
#include "geometry/instrument_keys.hpp"

#include <fmt/format.h>

namespace searle::geometry {

casefile::Keys<ConcentricCylinders> concentric_cylinders_keys() {
    casefile::Keys<ConcentricCylinders> keys;
    keys.key("bob_radius", &ConcentricCylinders::bob_radius)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("14 mm")
        .says("Radius of the bob, which turns.");
    keys.key("cup_radius", &ConcentricCylinders::cup_radius)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("15 mm")
        .says("Radius of the cup, which stands still; larger than bob_radius.");
    keys.key("height", &ConcentricCylinders::height)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("42 mm")
        .says("Wetted length that the torque is for.");
    keys.key("ends", &ConcentricCylinders::ends)
        .is_boolean()
        .example("false")
        .not_in_new()
        .says("Solve the fluid below and above the bob too, not only a slice of the gap.");
    keys.key("bottom_gap", &ConcentricCylinders::bottom_gap)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .example("0 mm")
        .not_in_new()
        .says("With ends = true: from the bob's flat bottom to the floor; needed there.");
    keys.key("top_gap", &ConcentricCylinders::top_gap)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .example("0 mm")
        .not_in_new()
        .says("With ends = true: from the bob's top to the free surface; 0: the fluid ends there.");
    keys.key("shaft_radius", &ConcentricCylinders::shaft_radius)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .example("0 mm")
        .not_in_new()
        .says("With top_gap above 0: radius of the shaft, thinner than the bob; needed there.");
    keys.key("offset", &ConcentricCylinders::offset)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .example("0 mm")
        .not_in_new()
        .says("Distance of the bob's axis from the cup's, for engine = \"openfoam\"; smaller than "
              "the gap.");
    keys.check([](const ConcentricCylinders& gap, casefile::Findings& findings) {
        if (gap.bob_radius >= gap.cup_radius)
            findings.contradiction({"cup_radius", "bob_radius"},
                                   "the cup must be wider than the bob", "bob_radius < cup_radius");
        if (gap.offset > 0.0 && gap.bob_radius < gap.cup_radius && gap.offset >= gap.gap())
            findings.contradiction(
                {"offset", "cup_radius", "bob_radius"}, "the bob would touch the cup",
                fmt::format("0 mm to below {:.6g} mm, the gap", 1e3 * gap.gap()));
        if (gap.offset > 0.0 && gap.ends)
            findings.contradiction({"offset", "ends"},
                                   "an eccentric bob is solved as a slice without ends",
                                   "ends = false, or offset = \"0 mm\"");
        if (gap.ends && !(gap.bottom_gap > 0.0))
            findings.contradiction({"bottom_gap", "ends"}, "real ends need a gap below the bob",
                                   "bottom_gap above 0, such as \"5 mm\"");
        if (!gap.ends && gap.bottom_gap > 0.0)
            findings.contradiction({"bottom_gap", "ends"},
                                   "a slice without ends has no fluid there",
                                   "ends = true beside it");
        if (!gap.ends && gap.top_gap > 0.0)
            findings.contradiction({"top_gap", "ends"}, "a slice without ends has no fluid there",
                                   "ends = true beside it");
        const bool covered = gap.ends && gap.top_gap > 0.0;
        if (covered && !(gap.shaft_radius > 0.0 && gap.shaft_radius < gap.bob_radius))
            findings.contradiction({"shaft_radius", "top_gap"},
                                   "a covered bob hangs on a shaft thinner than itself",
                                   "0 < shaft_radius < bob_radius");
        if (!covered && gap.shaft_radius > 0.0)
            findings.contradiction({"shaft_radius", "top_gap"}, "no fluid reaches the shaft",
                                   "ends = true and top_gap above 0 beside it");
    });
    return keys;
}

} // namespace searle::geometry
