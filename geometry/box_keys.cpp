#include "geometry/instrument_keys.hpp"

namespace searle::geometry {

casefile::Keys<Box> box_keys() {
    casefile::Keys<Box> keys;
    keys.key("gap", &Box::gap)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("1 mm")
        .says("Distance between the walls.");
    keys.key("length", &Box::length)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("88 mm")
        .says("Extent along the flow.");
    keys.key("width", &Box::width)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .required()
        .example("42 mm")
        .says("Extent along the vorticity, across flow and gap.");
    return keys;
}

} // namespace searle::geometry
