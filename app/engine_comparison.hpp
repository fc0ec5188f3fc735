#pragma once

#include "app/solved_case.hpp"

#include <string>
#include <vector>

namespace searle::app {

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

/// @param solved  the same case, engine by engine, at least one
[[nodiscard]] std::vector<EngineAgreement> agreements(const std::vector<SolvedCase>& solved);

/// A table for people, with the ratio of processor times.
[[nodiscard]] std::string agreement_table(const std::vector<EngineAgreement>& agreements);

/// Columns row, shear_rate_1_s, and of each engine stress and error; difference over joint error.
[[nodiscard]] std::string comparison_csv(const std::vector<SolvedCase>& solved);

} // namespace searle::app
