#pragma once

#include "geometry/mesh.hpp"
#include "geometry/mesh_subject.hpp"

#include <string>
#include <vector>

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

/// A mesh with what it stands for.
struct BuiltMesh {
    Mesh mesh;
    MeshDomain domain;
    MeshChoices choices;
    std::vector<std::string> notes; ///< choices that a user should know of, a sentence each

    /// Part of the whole instrument's turn (or of a box's length) that the mesh holds.
    [[nodiscard]] double part() const;
    /// Volume, areas and section of the mesh as they must come out: with chords (of second
    /// order: parabolas) in place of arcs. The meshed part only, not the whole turn.
    [[nodiscard]] OutlineMeasures expected() const;
    /// The same of the true shape, with arcs.
    [[nodiscard]] OutlineMeasures exact() const;

private:
    [[nodiscard]] OutlineMeasures expected_of_curved_cells() const;
};

/// Settles the settings for a subject. Throws MeshError.
[[nodiscard]] MeshChoices choices_for(const MeshSubject& subject, const MeshSettings& settings);

/// Makes the mesh. The number of cells is known, and refused when it is beyond
/// settings.most_cells, before memory is taken for them.
/// Throws MeshError, and MeshToolMissing when triangles are asked for and gmsh is not here.
[[nodiscard]] BuiltMesh build_mesh(const MeshSubject& subject, const MeshSettings& settings);

} // namespace searle::geometry
