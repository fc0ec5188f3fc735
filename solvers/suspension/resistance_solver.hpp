#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/suspension/lubrication_pairs.hpp"
#include "solvers/suspension/mixture_profile.hpp"
#include "solvers/suspension/pair_resistance.hpp"

#include <array>

namespace searle::solvers::suspension {

/// Finds the particles' motions from the forces on them: (D + R) V = F, with Stokes' drag D and the
/// resistance R of near pairs; between walls less what the fluid that follows takes back
/// (MixtureProfile). Symmetric and positive definite: conjugate gradients from the motions of the
/// step before, with the inverse of D + R's blocks of 6 as preconditioner.
class ResistanceSolver {
public:
    /// @param count particles  @param viscosity Pa s  @param length_unit m, of Motion's rotations
    ResistanceSolver(std::size_t count, double viscosity, double length_unit, int threads);

    /// Takes the drags of the particles and the films and springs of their pairs.
    void prepare(const particles::ParticleStore& particles,
                 const particles::AlignedVector<NearPair>& pairs);

    struct Outcome {
        int iterations{};
        double residual{}; ///< over the forces, in the preconditioner's norm
        bool converged{};
    };
    /// When a solve may end.
    struct Goal {
        double residual_share{}; ///< of the forces, in the preconditioner's norm, may be left over
        /// If not 0: the work of what is left over in this uniform shear, by which the force on the
        /// wall is off from the mean stress of the box, stays below `largest_work`, W.
        double shear_rate{};
        double largest_work{};
    };
    /// @param profile  the fluid between walls, prepared; null without walls
    /// @param motions  where to start; where it ended
    [[nodiscard]] Outcome solve(MixtureProfile* profile, const Goal& goal, const Motions& forces,
                                Motions& motions);

    [[nodiscard]] const particles::Column& drag() const { return drag_; }
    /// Over the length unit's square.
    [[nodiscard]] const particles::Column& turning_drag() const { return turning_drag_; }

private:
    void apply(const Motions& in, MixtureProfile* profile, Motions& out);
    void precondition(const Motions& in, Motions& out) const;
    [[nodiscard]] double dot(const Motions& a, const Motions& b) const;
    [[nodiscard]] double work_in_shear(const Motions& forces, double rate) const;

    double viscosity_;
    double length_unit_;
    int threads_;
    PairResistance resistance_;
    particles::AlignedVector<std::array<double, 36>> blocks_; ///< inverse of the diagonal blocks
    particles::AlignedVector<char> paired_; ///< whether a particle has a near pair
    particles::Column drag_, turning_drag_;
    particles::Column height_; ///< of the particles across the gap
    Motions residual_, direction_, image_, scaled_;
};

} // namespace searle::solvers::suspension
