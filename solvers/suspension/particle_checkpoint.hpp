#pragma once

#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"
#include "solvers/suspension/checkpoint.hpp"
#include "solvers/suspension/suspension_motion.hpp"

namespace searle::solvers::suspension {

/// Particles, box, neighbour list with its springs, and counts: what every motion has.
void put_particles(Checkpoint& into, const particles::ParticleStore& particles,
                   const particles::ShearBox& box, const particles::NeighbourList& list,
                   const StepCounts& counts);
void get_particles(const Checkpoint& from, particles::ParticleStore& particles,
                   particles::ShearBox& box, particles::NeighbourList& list, StepCounts& counts);

} // namespace searle::solvers::suspension
