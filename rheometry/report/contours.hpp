#pragma once

#include "rheometry/fields/section_fields.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace searle::rheometry::report {

/// A scalar, continuous and linear in triangles, for drawing.
struct DrawnScalar {
    std::vector<fields::SectionPoint> points;
    std::vector<double> values;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< anticlockwise; all values finite
    /// Sides with one triangle alone: bit k for the side from corner k to the next.
    std::vector<std::uint8_t> border;
    std::vector<double> area; ///< of each triangle
};

/// The section's field, points that lie upon each other joined and their values averaged; each
/// quadrilateral in four triangles around its centre. Quadrilaterals where a value is not finite
/// are left out.
[[nodiscard]] DrawnScalar drawn_scalar(const fields::SectionFields& section,
                                       std::string_view field);

using Polyline = std::vector<fields::SectionPoint>;

/// Outlines of the region where the scalar is >= level, as closed loops with the region to the
/// left.
[[nodiscard]] std::vector<Polyline> region_above(const DrawnScalar& scalar, double level);

/// The lines where the scalar is `level`, closed ones with their first point again at the end.
[[nodiscard]] std::vector<Polyline> level_lines(const DrawnScalar& scalar, double level);

/// The value below which the given share (0 ... 1) of the area lies; 0 without triangles.
[[nodiscard]] double area_quantile(const DrawnScalar& scalar, double share);

} // namespace searle::rheometry::report
