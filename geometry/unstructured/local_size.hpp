#pragma once

#include "geometry/outline.hpp"
#include "geometry/unstructured/triangulation.hpp"

#include <vector>

namespace searle::geometry {

/// The cell size that a triangulation shall have at a point of one outline's fluid, m.
class LocalSize {
public:
    LocalSize(const Outline& outline, const TriangleSizes& sizes);

    [[nodiscard]] double at(const SectionPoint& point) const;
    /// Roughly the number of triangles that these sizes lead to.
    [[nodiscard]] double expected_triangles() const;
    /// The same of tetrahedra in the solid that the section sweeps.
    /// @param extent  rad about the axis (revolved), or m
    [[nodiscard]] double expected_tetrahedra(bool revolved, double extent) const;

private:
    /// Sums over samples beside the walls: of what `cells` gives for a place, its size and its
    /// area.
    template <class Cells>
    [[nodiscard]] double sum_over_section(Cells cells) const;
    [[nodiscard]] double width_at(const SectionPoint& point) const;

    const Outline& outline_;
    TriangleSizes sizes_;
    std::vector<std::size_t> rotor_edges_;
    std::vector<std::size_t> fixed_edges_;
    /// Re-entrant corners, and the local size there.
    std::vector<SectionPoint> corners_;
    std::vector<double> corner_sizes_;
};

} // namespace searle::geometry
