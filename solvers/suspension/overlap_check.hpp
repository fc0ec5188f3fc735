#pragma once

#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/wall_forces.hpp"
#include "solvers/suspension/suspension_input.hpp"

#include <optional>

namespace searle::solvers::suspension {

/// Throws StepFailure where two particles, or one and a wall, overlap by more than a fifth of the
/// smallest radius, which is no contact any more: who, how deep, when, which key is too soft.
/// @param step  s, where it may have been too long as well
void check_overlaps(const particles::PairSums& pairs, const particles::WallSums& walls,
                    const particles::ParticleStore& particles, const ParticleSettings& settings,
                    double time, std::optional<double> step = {});

} // namespace searle::solvers::suspension
