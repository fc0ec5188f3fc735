#pragma once

#include "geometry/mesh_build.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::geometry {

/// A measure beside its closed form.
struct CheckedMeasure {
    std::string name; ///< a patch, or "fluid"
    std::size_t faces{};
    double value{}; ///< m^2 or m^3 (of a plane section m or m^2)
    double exact{}; ///< of the true shape with arcs
    double
        expected{}; ///< with the chords that the mesh has in place of arcs; of curved cells: exact

    /// value / expected - 1
    [[nodiscard]] double error() const;
};

/// What a mesh is worth; figures as checkMesh and Verdict define them.
struct MeshQuality {
    std::size_t cells{};
    std::size_t points{};
    CheckedMeasure volume;
    std::vector<CheckedMeasure> areas;
    double least_scaled_jacobian{}; ///< of a cell's corners, -1 to 1; 1: right angles everywhere
    double largest_aspect_ratio{};  ///< longest over shortest edge of a cell
    double largest_non_orthogonality{}; ///< deg, between a face's normal and the line of its cells
    double
        largest_skewness{}; ///< distance of that line from the face's centre over the line's length
    double largest_growth{};   ///< extent of a cell over that of its neighbour, across their face
    double least_volume{};     ///< m^3 (m^2)
    std::size_t inverted{};    ///< cells of negative volume
    std::size_t misoriented{}; ///< faces that look the wrong way
    std::size_t unmatched{};   ///< faces without a neighbour or a patch
    double openness{};         ///< largest |sum of a cell's face areas| / sum of |face areas|
    /// What is wrong, a sentence each; empty: the mesh is good.
    std::vector<std::string> faults;
};

/// Measures a mesh and compares it with its domain.
[[nodiscard]] MeshQuality quality_of(const BuiltMesh& built);

} // namespace searle::geometry
