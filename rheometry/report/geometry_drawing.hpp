#pragma once

#include "geometry/instrument.hpp"

#include <string>

namespace searle::rheometry::report {

/// Dimensioned drawing of the instrument as a complete SVG file: vertical half-section with the
/// axis on the left (the box: an oblique view). To scale where all parts can be seen; a note in the
/// drawing says where it is not, and a narrow gap is shown again, magnified.
/// The instrument must be valid (positive lengths, bob < cup).
[[nodiscard]] std::string geometry_drawing(const geometry::Instrument& instrument);

/// The same as an <svg> element that needs figure_style() in the page; at most one a page.
/// @param periodic  a box without walls, between images of itself
[[nodiscard]] std::string geometry_drawing_for_page(const geometry::Instrument& instrument,
                                                    bool periodic = false);

} // namespace searle::rheometry::report
