#pragma once

#include "geometry/mesh.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace searle::solvers::openfoam {

/// Velocity of each cell at a time; empty where the file is missing or cannot be read.
[[nodiscard]] std::vector<geometry::Point> velocity_at(const std::filesystem::path& folder,
                                                       const std::string& time, std::size_t cells);

} // namespace searle::solvers::openfoam
