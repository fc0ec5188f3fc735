#pragma once

#include "geometry/mesh.hpp"

#include <string>

namespace searle::geometry {

/// A plane section (dimension 2) as an SVG file: its cells, the patches in colour with a legend,
/// and beside it the neighbourhood of the rotor's lower edge, magnified.
/// @param gap    narrowest distance between rotor and cup, m: the magnified part's scale
/// @param title  plain text above the picture
[[nodiscard]] std::string mesh_picture(const Mesh& section, double gap, const std::string& title);

} // namespace searle::geometry
