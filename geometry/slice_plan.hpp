#pragma once

#include "geometry/mesh.hpp"

namespace searle::geometry {

/// A slice as seen along its axis, for a picture: the faces of the patch "slice_bottom" as plane
/// cells of straight edges, anticlockwise, x and y kept, with the walls that end there as patches
/// of lines in the slice's order. Empty where there is no such patch.
[[nodiscard]] Mesh slice_plan(const Mesh& slice);

} // namespace searle::geometry
