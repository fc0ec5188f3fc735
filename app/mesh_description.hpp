#pragma once

#include "app/summary_json.hpp"
#include "rheometry/report/report_input.hpp"
#include "solvers/axisymmetric/section_shape.hpp"

namespace searle::app {

/// Picture and checks of the mesh that a run was solved on.
/// Throws std::runtime_error when the note does not describe a section of this shape.
[[nodiscard]] rheometry::report::MeshDescription
mesh_description(const solvers::axisymmetric::SectionShape& shape, const MeshNote& note);

} // namespace searle::app
