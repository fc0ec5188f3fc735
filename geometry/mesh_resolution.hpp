#pragma once

#include "geometry/mesh_settings.hpp"

#include <vector>

namespace searle::geometry {

/// Cells across one gap.
struct GapCells {
    std::vector<double> fractions; ///< from rotor to fixed wall or back (symmetric), 0 to 1
    double wall_cell{};            ///< size at the walls, m
};

/// Cell sizes that follow from the settings, m.
struct Resolution {
    double mean_cell{};  ///< across the narrowest gap
    double wall_cell{};  ///< at the gap's walls; also where walls have re-entrant corners
    double axial_cell{}; ///< largest along the cylindrical part
    double bulk_cell{};  ///< largest away from the gap
    double growth{};     ///< from cell to cell, >= 1
};

/// @param gap     narrowest gap, m
/// @param height  of the meshed part of the cylinder, m
/// @param width   radius of the rotor, or another length over which the bulk extends, m
/// Throws MeshError where the settings contradict each other or the gap.
[[nodiscard]] Resolution resolution_for(double gap, double height, double width,
                                        const MeshSettings& settings);

/// The cells across a gap (m), counted for that gap. Throws MeshError.
[[nodiscard]] GapCells cells_across(double gap, const MeshSettings& settings);

/// Cells along a length, bounded before memory is taken. Throws MeshError when there would be more
/// than `most`; `what` names the length.
int bounded_count(double cells, std::int64_t most, const char* what);

} // namespace searle::geometry
