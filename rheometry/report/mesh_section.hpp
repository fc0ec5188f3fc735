#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>

namespace searle::rheometry::report {

/// HTML of the picture and the table of a mesh, under a heading of its own.
[[nodiscard]] std::string mesh_section(const MeshDescription& mesh, int figure, int table);

} // namespace searle::rheometry::report
