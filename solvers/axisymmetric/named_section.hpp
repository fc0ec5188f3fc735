#pragma once

#include "geometry/mesh_build.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"

namespace searle::solvers::axisymmetric {

/// The solver's division of a section as a plane mesh in metres (x = r, y = z) with the names that
/// geometry gives to the walls of a DIN bob, so that it is checked and drawn as any mesh is.
[[nodiscard]] geometry::BuiltMesh named_section(const geometry::DinBob& bob,
                                                const SectionLines& lines);

} // namespace searle::solvers::axisymmetric
