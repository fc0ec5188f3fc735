#pragma once

#include "app/solved_case.hpp"

#include <string_view>
#include <vector>

namespace searle::app {

/// What a truth rests on.
enum class TruthBasis { none, digits, series, finer_run };

/// "50 digits", "exact series", "a finer run"; empty for none.
[[nodiscard]] std::string_view name_of(TruthBasis basis);

/// What a solved case is held to.
struct SceneTruth {
    std::vector<double> torque; ///< N m (N), row by row
    std::vector<double> error;  ///< of the truth itself, same unit
    TruthBasis basis = TruthBasis::none;
};

/// @param solved   with rows that are finished
/// @param seconds  CPU time that a finer run may take; the rows it has by then are held to it
[[nodiscard]] SceneTruth truth_of(const SolvedCase& solved, double seconds);

} // namespace searle::app
