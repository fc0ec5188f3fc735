#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/suspension/lubrication_pairs.hpp"
#include "solvers/suspension/mixture_profile.hpp"

#include <array>

namespace searle::solvers::suspension {

/// Finds the particles' motions from the forces on them: (D + R) V = F, with Stokes' drag D and the
/// resistance R of near pairs; between walls less what the fluid that follows takes back
/// (MixtureProfile). Symmetric and positive definite: conjugate gradients from the motions of the
/// step before, with the inverse of D + R's blocks of 6 as preconditioner.
class ResistanceSolver {
public:
    /// @param count particles  @param viscosity Pa s  @param length_unit m, of Motion's rotations
    ResistanceSolver(std::size_t count, double viscosity, double length_unit);

    /// Takes the drags of the particles and the blocks of their pairs.
    void prepare(const particles::ParticleStore& particles,
                 const particles::AlignedVector<NearPair>& pairs);

    struct Outcome {
        int iterations{};
        double residual{}; ///< over the forces, in the preconditioner's norm
        bool converged{};
    };
    /// @param profile         the fluid between walls, prepared; null without walls
    /// @param residual_share  of the forces, in the preconditioner's norm, that may be left over
    /// @param motions         where to start; where it ended
    Outcome solve(const particles::AlignedVector<NearPair>& pairs, MixtureProfile* profile,
                  double residual_share, const Motions& forces, Motions& motions);

    [[nodiscard]] const particles::Column& drag() const { return drag_; }
    /// Over the length unit's square.
    [[nodiscard]] const particles::Column& turning_drag() const { return turning_drag_; }

private:
    void precondition(const Motions& in, Motions& out) const;

    double viscosity_;
    double length_unit_;
    particles::AlignedVector<std::array<double, 36>> blocks_; ///< inverse of the diagonal blocks
    particles::AlignedVector<char> paired_; ///< whether a particle has a near pair
    particles::Column drag_, turning_drag_;
    Motions residual_, direction_, image_, scaled_;
};

} // namespace searle::solvers::suspension
