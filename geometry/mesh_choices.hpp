#pragma once

#include "geometry/mesh_subject.hpp"

namespace searle::geometry {

/// The settings with every choice made.
struct MeshChoices {
    MeshExtent extent = MeshExtent::wedge;
    CellStyle cells = CellStyle::hexahedra;
    VertexRadius vertices = VertexRadius::wall;
    double angle{};      ///< rad, of the meshed part; of a box the part of its length times 2 pi
    int angular_cells{}; ///< or along the flow of a box; 0 for a section
    int order = 1;
    double radius_factor = 1.0; ///< on every radius of the mesh
};

/// What is meshed of a body of revolution whose rotor is centred.
[[nodiscard]] MeshExtent extent_of(const MeshSettings& settings);

/// Settles the settings for a domain of this subject. Throws MeshError.
[[nodiscard]] MeshChoices choices_in(const MeshDomain& domain, const MeshSubject& subject,
                                     const MeshSettings& settings);

/// Largest radius of the fluid, m.
[[nodiscard]] double outer_radius(const MeshDomain& domain);

} // namespace searle::geometry
