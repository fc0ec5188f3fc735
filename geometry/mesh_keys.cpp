#include "geometry/instrument_keys.hpp"

namespace searle::geometry {

casefile::Keys<MeshSettings> mesh_keys() {
    casefile::Keys<MeshSettings> keys;
    keys.key("cells_across_gap", &MeshSettings::cells_across_gap)
        .is_integer()
        .at_least("1")
        .at_most("100000")
        .example("20")
        .or_absent_as("auto", "as many as the accuracy asks for")
        .says("Cells from the bob to the cup.");
    keys.key("wedge_angle", &MeshSettings::wedge_angle)
        .measures(casefile::angle)
        .above("0 deg")
        .at_most("360 deg")
        .example("5 deg")
        .or_absent_as("auto", "as the model needs")
        .says("Angle of the meshed slice; the torque is always the whole instrument's.");
    keys.key("slice_height", &MeshSettings::slice_height)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("1 mm")
        .or_absent_as("auto", "as the model needs")
        .says("Height of the meshed slice; the torque is always for the geometry's height.");
    keys.key("order", &MeshSettings::order)
        .is_integer()
        .at_least("1")
        .at_most("2")
        .example("2")
        .or_absent_as("auto", "as the model needs")
        .says("Order of the cells: 1 straight, 2 curved along the walls.");
    return keys;
}

} // namespace searle::geometry
