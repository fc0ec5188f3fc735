#pragma once

#include "app/solved_case.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// The results of one case, engine by engine; the first is what the others are held against.
struct ComparedCase {
    std::string name; ///< of the case in its sweep; empty where it stands alone
    std::vector<const SolvedCase*> solved;
};

/// One engine's results against the first one's.
struct EngineAgreement {
    std::string engine;
    long rows{};               ///< compared: those that both finished
    long within{};             ///< of them: the stresses differ by no more than both errors
    double worst_difference{}; ///< relative to the first engine's stress
    double worst_joint{};      ///< largest difference over the sum of both errors
    double largest_error{};    ///< the engine's own estimate, relative
    double cpu_seconds{};      ///< reading, planning, solving, converting
    double wall_seconds{};
};

/// @param compared  at least one engine's results
[[nodiscard]] std::vector<EngineAgreement> agreements(const ComparedCase& compared);

/// A table for people, with the ratio of processor times.
[[nodiscard]] std::string agreement_table(const ComparedCase& compared);

/// The same in a sentence for each engine after the first.
[[nodiscard]] std::vector<std::string> agreement_remarks(const ComparedCase& compared);

/// Columns row, time_s, shear_rate_1_s, and of each engine stress and error; difference over joint
/// error. Several cases stand below each other with the column `case` in front; a new header says
/// where other engines finished.
[[nodiscard]] std::string comparison_csv(const std::vector<ComparedCase>& cases);

} // namespace searle::app
