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

private:
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
