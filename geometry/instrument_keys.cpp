#include "geometry/instrument_keys.hpp"

#include "geometry/profile_outline.hpp"

namespace searle::geometry {

casefile::Keys<GeometryAsWritten> geometry_keys() {
    const auto instrument = &GeometryAsWritten::instrument;
    casefile::Keys<GeometryAsWritten> keys;
    keys.selector("type", "The kind of instrument.");
    keys.alternative("single-gap", "a bob turning in a cup", instrument,
                     concentric_cylinders_keys());
    keys.alternative("double-gap", "a thin cylinder turning between a post and a cup", instrument,
                     double_gap_keys());
    keys.alternative("din-bob", "a bob with a conical tip after ISO 3219 / DIN 53019", instrument,
                     din_bob_keys());
    keys.alternative("box", "two parallel walls, one moving: the unrolled single gap", instrument,
                     box_keys());
    keys.alternative("profile",
                     "a rotor and a cup of any shape, as polylines; for meshes and OpenFOAM",
                     instrument, profile_keys());
    return keys;
}

Instrument instrument_of(const GeometryAsWritten& written) {
    struct Finish {
        Instrument operator()(const ConcentricCylinders& cylinders) const { return cylinders; }
        Instrument operator()(const DoubleGap& gap) const { return gap; }
        Instrument operator()(const Box& box) const { return box; }
        Instrument operator()(const Profile& profile) const { return nominal_cylinders(profile); }
        Instrument operator()(const DinBobAsWritten& din) const {
            DinBob bob = din.bob;
            bob.cup_radius =
                din.cup_radius ? *din.cup_radius : bob.bob_radius * din.radius_ratio.value_or(0.0);
            return bob;
        }
    };
    return std::visit(Finish{}, written.instrument);
}

} // namespace searle::geometry
