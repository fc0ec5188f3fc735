#pragma once

#include <optional>

namespace searle::geometry {

/// What a case asks of the mesh; absent means that the program chooses.
struct MeshSettings {
    std::optional<int> cells_across_gap; ///< >= 1
    std::optional<double> wedge_angle;   ///< angle of the meshed slice, rad, 0 < angle <= 2 pi
    std::optional<double> slice_height;  ///< height of the meshed slice, m, > 0
    std::optional<int> order;            ///< 1 (straight cells) or 2 (curved cells)
};

} // namespace searle::geometry
