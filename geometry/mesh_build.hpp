#pragma once

#include "geometry/mesh.hpp"
#include "geometry/mesh_choices.hpp"
#include "geometry/mesh_subject.hpp"

#include <string>
#include <vector>

namespace searle::geometry {

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

/// Makes the mesh. The number of cells is known, and refused when it is beyond
/// settings.most_cells, before memory is taken for them.
/// Throws MeshError, and MeshToolMissing when triangles are asked for and gmsh is not here.
[[nodiscard]] BuiltMesh build_mesh(const MeshSubject& subject, const MeshSettings& settings);

} // namespace searle::geometry
