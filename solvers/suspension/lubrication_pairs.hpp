#pragma once

#include "laws/contact/contact_law.hpp"
#include "solvers/particles/aligned_vector.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/wall_forces.hpp"

#include <array>
#include <optional>

namespace searle::solvers::suspension {

/// Velocity of each particle against the mean flow: three components, then three of the angular
/// velocity times one length (so that all have one unit), then two of padding.
using Motion = std::array<double, 8>;
using Motions = particles::AlignedVector<Motion>;

/// Length of Motions of so many particles: the last two are the lower and the upper wall's, and
/// stay 0. (Against the mean shear walls do turn, by half of its rate: a right side has that.)
inline std::size_t motions_for(std::size_t particles) { return particles + 2; }

/// One near pair, of two particles or of a particle and a wall: the film between it, its springs as
/// they resist the motion within a step, and the force that acts without motion.
struct NearPair {
    int first,
        second; ///< the number of particles stands for the lower wall, one more for the upper
    int listed; ///< its place in the neighbour list; of a wall the particle
    double nx, ny, nz;                ///< unit vector from first to second
    double distance;                  ///< of the centres, of a wall from the centre to it, m
    double lever_first, lever_second; ///< centre to the middle of the gap, over the length unit
    double squeeze, shear, mixed, pump, twist; ///< film; springs times the step are added
    double film_squeeze, film_shear;           ///< of the film alone
    double push;                         ///< force along n that pushes apart at the step's start, N
    double contact_push;                 ///< of it the contact's
    double stiffness, colloid_stiffness; ///< N/m, of contact and colloid, along n
    double tx, ty, tz;           ///< contact's tangential force on the second at the start, N
    double spring;               ///< N/m, stiffness of the contact's tangential spring
    double tangential_stiffness; ///< N/m, the same, 0 while sliding
    bool touches;
};

/// Whether the second is a wall, among so many particles.
inline bool is_wall(const NearPair& pair, std::size_t particles) {
    return static_cast<std::size_t>(pair.second) >= particles;
}
inline bool is_upper_wall(const NearPair& pair, std::size_t particles) {
    return static_cast<std::size_t>(pair.second) > particles;
}

struct LubricationSettings {
    double viscosity{};    ///< Pa s
    double farthest_gap{}; ///< xi beyond which a pair has no film
    double roughness{};    ///< added to xi: the film of touching spheres is finite
    double length_unit{};  ///< m, of Motion's rotations
};

/// Finds the near pairs and what acts in them.
/// @param step s, for the springs  @return sums over the contacts
particles::PairSums gather_near_pairs(const particles::ParticleStore& particles,
                                      const particles::ShearBox& box,
                                      const particles::NeighbourList& list,
                                      const LubricationSettings& settings,
                                      const std::optional<laws::contact::AnyContact>& contact,
                                      const particles::AnyColloid& colloid, double step,
                                      particles::AlignedVector<NearPair>& pairs);

/// Appends the particles near a wall, which has the same law of contact and no colloidal forces.
/// @return sums over the contacts: numbers, overlap and who has it
particles::WallSums gather_wall_pairs(const particles::ParticleStore& particles,
                                      const particles::ShearBox& box,
                                      const particles::NeighbourList& list,
                                      const LubricationSettings& settings,
                                      const std::optional<laws::contact::AnyContact>& contact,
                                      double step, particles::AlignedVector<NearPair>& pairs);

} // namespace searle::solvers::suspension
