#pragma once

#include "geometry/outline.hpp"
#include "geometry/profile.hpp"

namespace searle::geometry {

/// The closed outline of the fluid between rotor and cup, with the free surface and, where both
/// start on it, the axis. Throws MeshError when the ends do not fit together.
[[nodiscard]] Outline outline_of(const Profile& profile);

} // namespace searle::geometry
