#pragma once

#include "solvers/suspension/lubrication_pairs.hpp"
#include "solvers/suspension/mixture_profile.hpp"
#include "solvers/suspension/resistance_solver.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/suspension/suspension_motion.hpp"

#include <optional>
#include <vector>

namespace searle::solvers::suspension {

/// Beyond this gap over the mean radius a pair has no film of its own (as LF_DEM).
inline constexpr double farthest_film = 0.5;
/// Gap over the mean radius that roughness adds to every film (as LF_DEM).
inline constexpr double film_roughness = 1e-3;

/// The longest step, s, that an accuracy asks for at a shear rate (1/s, > 0).
[[nodiscard]] double overdamped_step(double accuracy, double shear_rate);

/// Particles without inertia in uniform shear (Lees-Edwards) or between walls, each with Stokes'
/// drag and torque, near pairs and particles near a wall with the film between them
/// (laws/lubrication), contacts and colloidal forces:
///     (D + R) V = F - R V_affine,  V against the mean shear,
/// between walls with the fluid's profile solved for together (MixtureProfile). The springs of
/// contacts and colloid enter as at the step's end, so that their stiffness does not limit it.
/// First order in time.
///
/// Stress: 2.5 phi mu rate of the isolated stresslets, and the symmetric first moments of the
/// films', contacts' and colloid's forces (the fluid's couples balance their antisymmetric part);
/// with walls also the couples of their films, so that the mean is what the moving wall feels.
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
    [[nodiscard]] std::vector<double> fluid_velocity() const override;

private:
    /// @param rate  largest of the mean shear until the end of the step, 1/s, >= 0
    [[nodiscard]] double choose_step(double rate) const;
    [[nodiscard]] ResistanceSolver::Goal goal_of_solve(double rate) const;
    /// A wall's turn about z against the mean shear, which turns by -rate / 2; in Motion's unit.
    [[nodiscard]] double wall_roll(double rate) const { return 0.5 * rate * films_.length_unit; }
    void check_places() const;
    void set_right_side(double rate);
    void solve(double rate);
    void keep_spring(const NearPair& pair, double x, double y, double z);
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
    particles::WallSums wall_sums_;
    ResistanceSolver solver_;
    std::optional<MixtureProfile> profile_; ///< between walls
    Motions motion_; ///< against the mean shear; of the last step until solved
    Motions right_side_;
    double step_{};
    double fastest_{};         ///< of the last step, against the fluid's mean flow, m/s
    double farthest_moved_{};  ///< in the last step, against the mean shear, m
    double fastest_closing_{}; ///< along the centres of a pair with colloidal forces, m/s
    double time_{};
    StepCounts counts_;
};

} // namespace searle::solvers::suspension
