#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <vector>

namespace searle::solvers::particles {

/// The volume nearest to each particle, m^3, in the particles' order: its cell of the power diagram
/// (geometry/power_cells.hpp), with its images across the periods, the sheared one included, and
/// with walls its mirror images, so that the walls bound the cells. The sum is the box's volume.
[[nodiscard]] std::vector<double> local_volumes(const ParticleStore& particles,
                                                const ShearBox& box);

} // namespace searle::solvers::particles
