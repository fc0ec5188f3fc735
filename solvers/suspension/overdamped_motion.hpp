#pragma once

#include "solvers/suspension/lubrication_pairs.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/suspension/suspension_motion.hpp"

#include <optional>
#include <vector>

namespace searle::solvers::suspension {

/// Beyond this gap over the mean radius a pair has no film of its own (as LF_DEM).
inline constexpr double farthest_film = 0.5;
/// Gap over the mean radius that roughness adds to every film (as LF_DEM).
inline constexpr double film_roughness = 1e-3;

/// Particles without inertia in uniform shear (Lees-Edwards), each with Stokes' drag and torque,
/// near pairs with the film between them (laws/lubrication), contacts and colloidal forces:
///     (D + R) V = F - R V_affine,  V against the mean flow,
/// symmetric and positive definite, solved by conjugate gradients with blocks of 6 as
/// preconditioner, starting from the velocities of the step before. The springs of contacts and
/// colloid enter as at the step's end, so that their stiffness does not limit it. First order in
/// time.
///
/// Stress: 2.5 phi mu rate of the isolated stresslets, and the symmetric first moments of the
/// films', contacts' and colloid's forces (the fluid's couples balance their antisymmetric part).
class OverdampedMotion final : public SuspensionMotion {
public:
    explicit OverdampedMotion(SuspensionInput input);

    StressSample advance(const WallSpeed& speed, double until) override;

    void save(Checkpoint& into) const override;
    void restore(const Checkpoint& from) override;

    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] const particles::ParticleStore& particles() const override { return particles_; }
    [[nodiscard]] const particles::ShearBox& box() const override { return box_; }
    [[nodiscard]] StepCounts counts() const override { return counts_; }
    [[nodiscard]] std::vector<double> fluid_velocity() const override { return {}; }

private:
    [[nodiscard]] double choose_step(double rate) const;
    void set_right_side(double rate);
    void precondition();
    void solve();
    [[nodiscard]] StressSample move(double step, double rate);

    SuspensionInput input_;
    particles::ParticleStore particles_;
    particles::ShearBox box_;
    std::optional<laws::contact::AnyContact> contact_;
    double friction_; ///< of the contact; 0 without one
    particles::AnyColloid colloid_;
    LubricationSettings films_;
    particles::NeighbourList list_;
    particles::AlignedVector<NearPair> pairs_;
    particles::PairSums sums_;
    Motions motion_; ///< against the mean flow; of the last step until solved
    Motions right_side_;
    Motions residual_, direction_, image_, scaled_;
    particles::AlignedVector<std::array<double, 36>> blocks_; ///< inverse of the diagonal blocks
    particles::AlignedVector<char> paired_; ///< whether a particle has a near pair
    particles::Column drag_, turning_drag_;
    double step_{};
    double fastest_{};         ///< of the last step, against the mean flow, m/s
    double fastest_closing_{}; ///< along the centres of a pair with colloidal forces, m/s
    double time_{};
    StepCounts counts_;
};

} // namespace searle::solvers::suspension
