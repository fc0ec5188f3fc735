#pragma once

#include "app/solved_case.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// What a solved case is held to.
struct SceneTruth {
    std::vector<double> torque; ///< N m (N), row by row
    std::vector<double> error;  ///< of the truth itself, same unit
    std::string basis;
};

/// @param solved   with rows that are finished
/// @param seconds  CPU time that a finer run may take; the rows it has by then are held to it
[[nodiscard]] SceneTruth truth_of(const SolvedCase& solved, double seconds);

} // namespace searle::app
