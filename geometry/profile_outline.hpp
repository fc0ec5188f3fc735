#pragma once

#include "geometry/concentric_cylinders.hpp"
#include "geometry/outline.hpp"
#include "geometry/profile.hpp"

namespace searle::geometry {

/// The closed outline of the fluid between rotor and cup, with the free surface and, where both
/// start on it, the axis. Throws MeshError when the ends do not fit together.
[[nodiscard]] Outline outline_of(const Profile& profile);

/// The cylinders that a profile's stress and rate refer to: widest radii of rotor and cup, and the
/// length of the rotor's walls at its widest radius (of its whole height where it has none).
[[nodiscard]] ConcentricCylinders nominal_cylinders(const Profile& profile);

} // namespace searle::geometry
