#include "casefile/reading.hpp"
#include "geometry/instrument_keys.hpp"

namespace searle::geometry {
namespace {

void declare_extent(casefile::Keys<MeshSettings>& keys) {
    keys.choice("extent", &MeshSettings::extent,
                std::vector<casefile::Named<MeshExtent>>{
                    {"section", MeshExtent::section, "the meridional section, plane"},
                    {"wedge", MeshExtent::wedge, "a thin wedge"},
                    {"sector", MeshExtent::sector, "a sector with periodic sides"},
                    {"full", MeshExtent::full, "all of it"}})
        .example("wedge")
        .or_absent_as("auto", "by the angle: a wedge up to 10 deg, a sector, the full turn")
        .says("How much of the instrument is meshed.");
    keys.key("wedge_angle", &MeshSettings::wedge_angle)
        .measures(casefile::angle)
        .above("0 deg")
        .at_most("360 deg")
        .example("5 deg")
        .or_absent_as("auto", "5 deg for a wedge, 90 deg for a sector")
        .says("Angle of the meshed slice; the torque is always the whole instrument's.");
    keys.key("slice_height", &MeshSettings::slice_height)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("1 mm")
        .or_absent_as("auto", "the whole height")
        .says("Height of the meshed slice; the torque is always for the geometry's height.");
    keys.key("floor_clearance", &MeshSettings::floor_clearance)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("2 mm")
        .or_absent_as("none", "both gaps are cut off at the rotor's edge")
        .says("Depth of the fluid under a double gap's rotor.");
}

void declare_resolution(casefile::Keys<MeshSettings>& keys) {
    keys.key("cells_across_gap", &MeshSettings::cells_across_gap)
        .is_integer()
        .at_least("1")
        .at_most("100000")
        .example("20")
        .or_absent_as("auto", "as many as the accuracy asks for; a mesh by itself has 20")
        .says("Cells from the bob to the cup.");
    keys.key("cell_size", &MeshSettings::cell_size)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("0.1 mm")
        .or_absent_as("auto", "as cells_across_gap says")
        .says("Size of all cells, in place of cells_across_gap.");
    keys.key("first_cell", &MeshSettings::first_cell)
        .measures(casefile::length)
        .at_least("1 nm")
        .at_most("1000 m")
        .example("10 um")
        .or_absent_as("auto", "as cells_across_gap says")
        .says("Height of the cells at the gap's walls, in place of cells_across_gap.");
    keys.key("growth", &MeshSettings::growth)
        .is_number()
        .at_least("1")
        .at_most("2")
        .example("1.2")
        .or_absent_as("auto", "1.2, less across gaps of many cells")
        .says("Growth of cells away from walls and corners; 1: uniform across the gap.");
    keys.key("angular_cells", &MeshSettings::angular_cells)
        .is_integer()
        .at_least("1")
        .at_most("1000000")
        .example("30")
        .or_absent_as("auto", "1 in a wedge, 3 deg each in a sector")
        .says("Cells around the axis; along the flow of a box.");
    keys.key("axial_cells", &MeshSettings::axial_cells)
        .is_integer()
        .at_least("1")
        .at_most("1000000")
        .example("100")
        .or_absent_as("auto", "graded to the corners; 1 in a slice")
        .says("Cells along the cylindrical part.");
    keys.key("most_cells", &MeshSettings::most_cells)
        .is_integer()
        .at_least("1")
        .at_most("1000000000")
        .example("20000000")
        .says("A mesh of more cells is refused before memory is taken.");
}

void declare_cells(casefile::Keys<MeshSettings>& keys) {
    keys.choice("cells", &MeshSettings::cells,
                std::vector<casefile::Named<CellStyle>>{
                    {"hexahedra", CellStyle::hexahedra, "structured; quadrangles in a section"},
                    {"prisms", CellStyle::prisms, "swept from unstructured triangles"},
                    {"tetrahedra", CellStyle::tetrahedra, "the same, split"}})
        .example("hexahedra")
        .or_absent_as("auto", "hexahedra; prisms for a profile")
        .says("Shape of the cells.");
    keys.key("order", &MeshSettings::order)
        .is_integer()
        .at_least("1")
        .at_most("2")
        .example("2")
        .or_absent_as("auto", "as the model needs")
        .says("Order of the cells: 1 straight, 2 curved along the walls.");
    keys.choice("rotor_walls", &MeshSettings::rotor_walls,
                std::vector<casefile::Named<RotorWalls>>{
                    {"together", RotorWalls::together, "one patch, bob"},
                    {"separate", RotorWalls::separate,
                     "bob_inner and bob_outer, for the torque of each wall"}})
        .example("separate")
        .or_absent_as("auto", "together")
        .says("Patches of a double gap's rotor.");
    keys.choice("vertices", &MeshSettings::vertices,
                std::vector<casefile::Named<VertexRadius>>{
                    {"wall", VertexRadius::wall, "on the true radii"},
                    {"face", VertexRadius::face,
                     "at radius / cos(half a cell's angle): the faces' centres on the true radii"}})
        .example("face")
        .or_absent_as("auto", "face in a wedge, wall otherwise")
        .says("Where the vertices of straight cells lie.");
}

void check_resolution(const MeshSettings& settings, casefile::Findings& findings) {
    const int given = settings.cells_across_gap.has_value() + settings.cell_size.has_value() +
                      settings.first_cell.has_value();
    if (given > 1)
        findings.contradiction({"cells_across_gap", "cell_size", "first_cell"},
                               "the resolution is given more than once",
                               "one of cells_across_gap, cell_size and first_cell");
}

} // namespace

casefile::Keys<MeshSettings> mesh_keys() {
    casefile::Keys<MeshSettings> keys;
    declare_extent(keys);
    declare_resolution(keys);
    declare_cells(keys);
    keys.check(check_resolution);
    return keys;
}

} // namespace searle::geometry
