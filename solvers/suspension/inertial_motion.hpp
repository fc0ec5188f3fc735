#pragma once

#include "solvers/particles/motion.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/wall_forces.hpp"
#include "solvers/suspension/drag_coefficients.hpp"
#include "solvers/suspension/fluid_profile.hpp"
#include "solvers/suspension/step_control.hpp"
#include "solvers/suspension/step_limits.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/suspension/suspension_motion.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace searle::solvers::suspension {

/// Particles with mass whose hydrodynamics is drag alone ("drag"), or drag and the stresslets of
/// isolated spheres ("stresslet"). With walls, four-way coupled with the fluid's profile; in a
/// Lees-Edwards box the mean flow is uniform shear and stays it.
///
/// Integrators: implicit-drag (exact for a held force), or explicit (velocity Verlet, as the
/// paper). A step by StepControl where there are colloidal forces, and while particles touch no
/// longer than a share of the contact's relaxation; a given time_step is kept.
class InertialMotion final : public SuspensionMotion {
public:
    explicit InertialMotion(SuspensionInput input);

    StressSample advance(const WallSpeed& speed, double until) override;

    void save(Checkpoint& into) const override;
    void restore(const Checkpoint& from) override;

    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] const particles::ParticleStore& particles() const override { return particles_; }
    [[nodiscard]] const particles::ShearBox& box() const override { return box_; }
    [[nodiscard]] StepCounts counts() const override;
    [[nodiscard]] std::vector<double> fluid_velocity() const override;

    /// Momentum in x of the particles and the fluid, less what the walls gave, N s: constant.
    [[nodiscard]] double momentum_defect() const;

private:
    void rebuild();
    void meet_fluid(double rate);
    /// Explicit steps: what the fluid and the walls give within half a step.
    void count_half_kick(double step);
    void evaluate(double wall_speed, double step, bool sampling);
    [[nodiscard]] int interval_for(double step) const;
    /// One step of the particles; `surroundings_` is up to date.
    void move(double wall_speed, double step, bool sampling);
    [[nodiscard]] StressSample sample(const WallShear& wall, double duration, double rate,
                                      double end_speed) const;
    [[nodiscard]] double largest_force_change() const;
    void check(double moved) const;

    SuspensionInput input_;
    particles::ParticleStore particles_;
    particles::ShearBox box_;
    std::optional<laws::contact::AnyContact> contact_;
    particles::AnyColloid colloid_;
    std::unique_ptr<particles::PairForces> forces_;
    particles::NeighbourList list_;
    particles::Surroundings surroundings_;
    particles::Column fluid_fraction_;
    particles::Column bare_x_;                         ///< forces that are not the fluid's
    particles::Column before_x_, before_y_, before_z_; ///< forces of the step before
    std::vector<particles::Column*> companions_;
    particles::Brownian brownian_;
    std::optional<FluidProfile> profile_;
    DragChoice drag_;
    StepLimits limits_;
    StepControl control_;
    bool explicit_steps_{};
    bool forces_known_{};
    bool change_known_{};
    double weight_z_{}; ///< (rho_p - rho_f) g, N/m^3
    double time_{};
    double last_step_{};
    double wall_contact_impulse_{}; ///< of both walls' contacts on the particles in x, N s
    particles::PairSums pair_sums_;
    particles::WallSums wall_sums_;
    double largest_moved_{};
    StepCounts counts_;
};

} // namespace searle::solvers::suspension
