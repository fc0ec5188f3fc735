#include "casefile/reading.hpp"
#include "geometry/instrument_keys.hpp"

#include <fmt/format.h>

namespace searle::geometry {
namespace {

void check_proportions(const DinBobAsWritten& written, casefile::Findings& findings) {
    const DinBob& bob = written.bob;
    if (written.cup_radius && written.radius_ratio)
        findings.contradiction({"cup_radius", "radius_ratio"},
                               "the cup is given twice, by its radius and by its ratio to the bob",
                               "one of cup_radius and radius_ratio");
    else if (!written.cup_radius && !written.radius_ratio)
        findings.contradiction({"cup_radius", "radius_ratio"}, "the cup is missing",
                               "one of cup_radius and radius_ratio, such as radius_ratio = 1.0847");
    else if (written.cup_radius && *written.cup_radius <= bob.bob_radius)
        findings.contradiction({"cup_radius", "bob_radius"}, "the cup must be wider than the bob",
                               "bob_radius < cup_radius");
    const double cone = bob.cone_height() / bob.bob_radius;
    // Not a number where the radius is a fault of its own.
    if (bob.bottom_ratio <= cone)
        findings.contradiction(
            {"bottom_ratio", "cone_angle"},
            fmt::format(
                "the cone's tip, {:.5g} bob radii below the cylinder's lower edge, does not "
                "stay above the cup's floor at {:.5g}",
                cone, bob.bottom_ratio),
            "bottom_ratio > 1 / tan(cone_angle / 2)");
}

} // namespace

casefile::Keys<DinBobAsWritten> din_bob_keys() {
    casefile::Keys<DinBobAsWritten> keys;
    keys.key(
            "bob_radius", [](auto& written) -> auto& { return written.bob.bob_radius; })
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("14 mm")
        .says("Radius of the bob's cylinder; all ratios are to it.");
    keys.key("radius_ratio", &DinBobAsWritten::radius_ratio)
        .is_number()
        .above("1")
        .at_most("1000")
        .example("1.0847")
        .defaults_to("none; this or cup_radius is given")
        .given_in_new()
        .says("Cup radius over bob radius; ISO 3219 says 1.0847.");
    keys.key("cup_radius", &DinBobAsWritten::cup_radius)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("15.2 mm")
        .defaults_to("none; this or radius_ratio is given")
        .offered_in_new()
        .says("Radius of the cup, in place of radius_ratio.");
    keys.key(
            "length_ratio", [](auto& written) -> auto& { return written.bob.length_ratio; })
        .is_number()
        .above("0")
        .at_most("1000")
        .example("3")
        .says("Length of the cylindrical part, which the torque is for.");
    keys.key(
            "bottom_ratio", [](auto& written) -> auto& { return written.bob.bottom_ratio; })
        .is_number()
        .above("0")
        .at_most("1000")
        .example("1")
        .says("Cup floor below the lower edge of the cylinder (not below the tip).");
    keys.key(
            "top_ratio", [](auto& written) -> auto& { return written.bob.top_ratio; })
        .is_number()
        .at_least("0")
        .at_most("1000")
        .example("1")
        .says("Free surface above the bob's top face.");
    keys.key(
            "shaft_ratio", [](auto& written) -> auto& { return written.bob.shaft_ratio; })
        .is_number()
        .above("0")
        .below("1")
        .example("0.3")
        .says("Radius of the shaft; thinner than the bob.");
    keys.key(
            "cone_angle", [](auto& written) -> auto& { return written.bob.cone_angle; })
        .measures(casefile::angle)
        .above("0 deg")
        .at_most("180 deg")
        .example("120 deg")
        .says("Full apex angle of the conical tip; 180 deg is a flat bottom.");
    keys.check(check_proportions);
    return keys;
}

} // namespace searle::geometry
