#pragma once

#include "geometry/mesh_quality.hpp"

#include <string>

namespace searle::app {

/// The checks of a mesh as a table for reading.
[[nodiscard]] std::string mesh_table(const geometry::BuiltMesh& built,
                                     const geometry::MeshQuality& quality);

/// The same as one JSON object: SI units, angles in degrees.
[[nodiscard]] std::string mesh_json(const geometry::BuiltMesh& built,
                                    const geometry::MeshQuality& quality);

} // namespace searle::app
