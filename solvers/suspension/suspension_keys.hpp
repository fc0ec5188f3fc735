#pragma once

#include "casefile/keys.hpp"
#include "solvers/suspension/suspension_settings.hpp"

namespace searle::solvers::suspension {

[[nodiscard]] casefile::Keys<ContactSettings> contact_keys();
[[nodiscard]] casefile::Keys<ColloidSettings> colloid_keys();
[[nodiscard]] casefile::Keys<ParticleSettings> particle_keys();
[[nodiscard]] casefile::Keys<CouplingSettings> coupling_keys();

} // namespace searle::solvers::suspension
