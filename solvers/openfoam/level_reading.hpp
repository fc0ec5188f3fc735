#pragma once

#include "solvers/openfoam/level_case.hpp"

namespace searle::solvers::openfoam {

/// Whether a steady row stands in the folder: row 0 is the first.
[[nodiscard]] bool row_is_finished(const LevelTask& task, std::size_t row);

/// Torques, balance and counts from the files of a level; `failure` only for what the numbers tell.
[[nodiscard]] LevelResult read_results(const LevelTask& task, const LevelCase& level);

} // namespace searle::solvers::openfoam
