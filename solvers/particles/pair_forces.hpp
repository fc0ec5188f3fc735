#pragma once

#include "laws/colloid/dlvo.hpp"
#include "laws/contact/contact_law.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <array>
#include <memory>
#include <optional>
#include <variant>

namespace searle::solvers::particles {

/// Sum over pairs of (vector from one to the other) (x) (force on the other), N m, row by row:
/// element 3 a + b has the vector's component a and the force's b. Repulsion gives positive
/// diagonals; the stress is minus this over the volume.
using Virial = std::array<double, 9>;

/// What one evaluation of the forces found.
struct PairSums {
    Virial contact{};
    Virial colloid{};
    double largest_overlap{}; ///< m, 0 without contacts
    int deepest_first = -1;   ///< ids of the pair with the largest overlap
    int deepest_second = -1;
    long contacts{}; ///< touching pairs
};

/// No force between particles that do not touch.
struct NoColloid {};
using AnyColloid = std::variant<NoColloid, laws::colloid::Dlvo<laws::colloid::WeakOverlap>,
                                laws::colloid::Dlvo<laws::colloid::ConstantPotential>>;

/// Surface distance up to which pairs act on each other, m.
[[nodiscard]] double reach_of(const AnyColloid& colloid);

/// Forces between particles, composed at compile time: what a scene lacks is not in the loop. The
/// sums have a fixed order for a number of threads.
class PairForces {
public:
    virtual ~PairForces() = default;
    /// Adds forces and torques to those of the particles, and moves the tangential springs by one
    /// step.
    /// @param step     s, for the springs; 0 leaves them
    /// @param sampling whether the virials are wanted
    virtual PairSums evaluate(ParticleStore& particles, const ShearBox& box, NeighbourList& list,
                              double step, bool sampling) = 0;
};

/// @param threads >= 1
[[nodiscard]] std::unique_ptr<PairForces>
make_pair_forces(const std::optional<laws::contact::AnyContact>& contact, const AnyColloid& colloid,
                 int threads);

} // namespace searle::solvers::particles
