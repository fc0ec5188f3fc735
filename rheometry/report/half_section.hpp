#pragma once

#include "rheometry/report/drafting.hpp"

#include <span>
#include <string>

namespace searle::rheometry::report {

/// From radius and height of an instrument (m) to pixels of its vertical half-section.
struct SectionScale {
    double axis_x{};  ///< pixel of r = 0
    double floor_y{}; ///< pixel of z = 0
    double per_metre_r{};
    double per_metre_z{};

    [[nodiscard]] Pixel at(double r, double z) const {
        return {axis_x + r * per_metre_r, floor_y - z * per_metre_z};
    }
    [[nodiscard]] bool to_scale() const { return per_metre_r == per_metre_z; }
};

/// One material between two radii, m.
struct Layer {
    double from{};
    double to{};
    Material material{};
};

/// Shows walls and gap around one place of a section again, magnified, in a circle.
/// `layers` go outwards without holes; the first and the last solid one reach out of the circle.
/// Fluid layers get their width as dimension; also solid ones between two fluid layers.
void magnify_gap(Drafting& drawing, const SectionScale& scale, std::span<const Layer> layers,
                 double z, Pixel centre, double radius);

/// "R_bob = 14 mm": a symbol with an index and a length.
[[nodiscard]] RichText length_text(std::string_view symbol, std::string_view index, double metres);

/// A length alone: "14 mm".
[[nodiscard]] RichText length_text(double metres);

} // namespace searle::rheometry::report
