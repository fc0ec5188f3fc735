#pragma once

#include <cstdint>
#include <optional>

namespace searle::geometry {

/// How much of the instrument the mesh holds.
enum class MeshExtent {
    section, ///< the meridional section, plane (r, z)
    wedge,   ///< a thin wedge about y = 0
    sector,  ///< a sector, its two sides a periodic pair
    full     ///< all of it
};

enum class CellStyle {
    hexahedra, ///< structured quadrangles, swept to hexahedra (prisms at the axis)
    prisms,    ///< unstructured triangles, swept to prisms
    tetrahedra ///< the same, split into tetrahedra
};

/// Where the vertices of a swept mesh with straight edges lie: chords are shorter than arcs.
enum class VertexRadius {
    wall, ///< on the true radius: faces cut the corner
    face  ///< at radius / cos(half a cell's angle): the centres of faces lie on the true radius
};

/// How the two walls of a double gap's rotor are named.
enum class RotorWalls {
    together, ///< one patch, bob: its torque is the rotor's
    separate  ///< bob_inner (beside the post) and bob_outer (beside the cup)
};

/// What a case asks of the mesh; absent means that the program chooses.
struct MeshSettings {
    std::optional<int> cells_across_gap{}; ///< >= 1
    std::optional<double> wedge_angle{};   ///< angle of the meshed slice, rad, 0 < angle <= 2 pi
    std::optional<double> slice_height{};  ///< height of the meshed slice, m, > 0
    std::optional<int> order{};            ///< 1 (straight cells) or 2 (curved cells)
    std::optional<MeshExtent> extent{};
    std::optional<CellStyle> cells{};
    std::optional<double> cell_size{};  ///< of all cells, m, in place of cells_across_gap
    std::optional<double> first_cell{}; ///< height of the cells at the gap's walls, m; likewise
    std::optional<double> growth{};     ///< from cell to cell away from walls and corners, >= 1
    std::optional<int> angular_cells{}; ///< >= 1
    std::optional<int> axial_cells{};   ///< along the cylindrical part, >= 1
    std::optional<VertexRadius> vertices{};
    std::optional<double> floor_clearance{}; ///< fluid under a double gap's rotor, m, > 0
    std::optional<RotorWalls> rotor_walls{};
    std::int64_t most_cells = 20'000'000; ///< a mesh of more cells is refused
};

} // namespace searle::geometry
