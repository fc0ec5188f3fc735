#pragma once

#include "laws/contact/contact_law.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

namespace searle::solvers::particles {

/// Contacts of the particles with the two walls, which have the law of a contact with a sphere of
/// infinite size and mass.
struct WallSums {
    double upper_x{}; ///< force of the particles on the upper (moving) wall along the flow, N
    double lower_x{}; ///< on the lower one
    double upper_y{}; ///< across the gap, positive: pushed outwards (up)
    double lower_y{};
    Virial contact{}; ///< vectors from the particles' centres to the walls, forces on the walls
    double largest_overlap{};
    int deepest = -1; ///< id of the particle with it
    long contacts{};
};

/// Adds the walls' forces to those of the particles, and moves the tangential springs by `step`.
/// @param upper_speed of the upper wall in x, m/s
WallSums add_wall_forces(const laws::contact::AnyContact& contact, ParticleStore& particles,
                         const ShearBox& box, NeighbourList& list, double upper_speed, double step);

} // namespace searle::solvers::particles
