#pragma once

#include "app/summary_json.hpp"
#include "geometry/din_bob.hpp"
#include "rheometry/report/report_input.hpp"

namespace searle::app {

/// Picture and checks of the mesh that a run was solved on.
/// Throws std::runtime_error when the note does not describe a section of this bob.
[[nodiscard]] rheometry::report::MeshDescription mesh_description(const geometry::DinBob& bob,
                                                                  const MeshNote& note);

} // namespace searle::app
