#pragma once

#include "solvers/suspension/suspension_input.hpp"

namespace searle::solvers::suspension {

/// What is claimed as numerical error of the step, as shares of parts of the stress; above what was
/// measured (docs/suspension.md).
struct ClaimedError {
    double forces{}; ///< of contacts, colloid and thermal motion
    double films{};  ///< of the hydrodynamic part
};

/// By the accuracy that decides the steps; first order in time where the case forces another step.
[[nodiscard]] ClaimedError claimed_error(const SuspensionInput& input);

} // namespace searle::solvers::suspension
