#include "casefile/reading.hpp"
#include "geometry/instrument_keys.hpp"

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
    keys.check([](const ConcentricCylinders& gap, casefile::Findings& findings) {
        if (gap.bob_radius >= gap.cup_radius)
            findings.contradiction({"cup_radius", "bob_radius"},
                                   "the cup must be wider than the bob", "bob_radius < cup_radius");
    });
    return keys;
}

} // namespace searle::geometry
