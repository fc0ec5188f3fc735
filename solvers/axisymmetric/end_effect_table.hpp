#pragma once

#include "rheometry/end_effect.hpp"
#include "solvers/progress.hpp"
#include "solvers/scene.hpp"

#include <span>
#include <vector>

namespace searle::solvers::axisymmetric {

/// End factors of a scene's instrument and fluid, each solved at its own speed.
struct EndEffectTable {
    std::vector<rheometry::EndEffect> rows; ///< those finished, in the order asked
    bool reached = true;                    ///< every row is as accurate as the scene asks
    bool interrupted{};
};

/// @param scene   whose instrument has ends (has_ends)
/// @param speeds  rad/s, > 0
[[nodiscard]] EndEffectTable end_effect_table(const Scene& scene, std::span<const double> speeds,
                                              const ProgressSink& progress);

/// Speeds for a table: those of the rows, each once; of many twelve, evenly spread in the
/// logarithm, down to a thousandth of the fastest. rad/s, increasing.
[[nodiscard]] std::vector<double> speeds_for_table(std::span<const double> row_speeds);

} // namespace searle::solvers::axisymmetric
