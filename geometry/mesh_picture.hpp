#pragma once

#include "geometry/mesh.hpp"

#include <optional>
#include <string>

namespace searle::geometry {

/// A plane section (dimension 2) as an SVG file: its cells, the patches in colour with a legend,
/// and beside it a part of it, magnified.
/// @param gap    narrowest distance between rotor and cup, m: the magnified part's scale
/// @param title  plain text above the picture
/// @param around what is magnified; the rotor's lower edge without it
[[nodiscard]] std::string mesh_picture(const Mesh& section, double gap, const std::string& title,
                                       std::optional<Point> around = std::nullopt);

} // namespace searle::geometry
