#pragma once

#include "casefile/keys.hpp"
#include "solvers/scene.hpp"

namespace searle::solvers {

/// The section [fluid].
[[nodiscard]] casefile::Keys<Fluid> fluid_keys();
/// The section [solver].
[[nodiscard]] casefile::Keys<SolverSettings> solver_keys();
/// The section [output].
[[nodiscard]] casefile::Keys<OutputSettings> output_keys();

} // namespace searle::solvers
