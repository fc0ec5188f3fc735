#pragma once

#include "solvers/particles/motion.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/suspension/linear_elements.hpp"

#include <vector>

namespace searle::solvers::suspension {

/// What the fluid has and what of the particles it feels.
struct ProfileOptions {
    double gap{};       ///< m
    double wall_area{}; ///< m^2
    int cells{};        ///< across the gap, >= 1
    double viscosity{}; ///< Pa s
    double density{};   ///< of the fluid, kg/m^3
    bool model_a = true;
    /// The isolated particles' stresslet, 2.5 phi mu du/dy, and their couple act on the flow.
    bool stresslets{};
};

/// Force on the moving wall along the flow, per area, that the drive must supply, Pa.
struct WallShear {
    double viscous{};   ///< mu du/dy and the inertia of the fluid that moves with the wall
    double stresslet{}; ///< of particles next to the wall, stresslet and couple
    double drag{};      ///< drag of particles next to the wall, which the wall's fluid carries
    [[nodiscard]] double hydrodynamic() const { return stresslet + drag; }
};

/// The volume-averaged flow between two walls, u(y) along x, one mean over each plane:
///     rho eps du/dt = eps d/dy(mu du/dy) - drag + d/dy(particle stresslets)          (Model A)
/// while each particle gets its drag and V_p d/dy(mu du/dy), so that both together carry the full
/// mu du/dy. Model B leaves d/dy(mu du/dy) whole to the fluid, with the drag over eps.
/// eps comes from the particles' volumes at their centres' linear weights.
///
/// Linear elements across the gap, implicit Euler. The drag is solved for together with the flow
/// (the particles' velocities after the step are linear in u), so no step is too long. Linear
/// weights both ways make the exchange of momentum exact, and of its first moment across the gap:
/// without inertia the mean stress is the wall's. Leaves out fluid that particles push across the
/// gap (du/dt instead of Du/Dt): of relative order Re_p, below 1e-4 in suspensions of micrometres.
class FluidProfile {
public:
    explicit FluidProfile(const ProfileOptions& options);

    /// Uniform shear with the upper wall at `wall_speed`.
    void set_uniform_shear(double wall_speed);

    /// Fluid fraction at the nodes from the particles' places.
    void gather_fractions(const particles::ParticleStore& particles);

    /// One fluid step, before the particles' own, with the fractions as gathered.
    /// `surroundings.drag` holds their coefficients, and `impulse_x` what the fluid gave them since
    /// the last fluid step; it is set to 0.
    /// @param forces_x  force on each particle that is not the fluid's, N
    /// @param step      of the fluid, s  @param wall_speed at its end, m/s
    WallShear advance(const particles::ParticleStore& particles,
                      particles::Surroundings& surroundings, const particles::Column& forces_x,
                      double step, double wall_speed);

    /// At the particles: the fluid fraction, and the force of d/dy(mu du/dy) on their volumes
    /// (Model A; as of the last step). Before advance().
    void interpolate_mixture(const particles::ParticleStore& particles,
                             particles::Surroundings& surroundings,
                             particles::Column& fluid_fraction) const;
    /// At the particles: velocity and half of the vorticity.
    void interpolate_flow(const particles::ParticleStore& particles,
                          particles::Surroundings& surroundings) const;

    /// Means over the gap of the stresslet and of the couple's part, Pa.
    [[nodiscard]] double mean_stresslet() const;

    [[nodiscard]] const std::vector<double>& velocity() const { return velocity_; }
    [[nodiscard]] const std::vector<double>& particle_fraction() const { return fraction_; }
    /// Sum of the changes of the fluid's momentum so far, N s.
    [[nodiscard]] double momentum_gained() const { return momentum_gained_; }
    /// Impulse that both walls gave the fluid so far, N s.
    [[nodiscard]] double wall_impulse() const { return wall_impulse_; }
    [[nodiscard]] double spacing() const { return elements_.spacing; }

    /// All that changes, for a checkpoint; restored by assigning the same columns.
    struct State {
        std::vector<double> velocity, viscous_force, couple, predicted;
        double momentum_gained{}, wall_impulse{};
    };
    [[nodiscard]] State state() const;
    void restore(const State& state);

private:
    void assemble(const particles::ParticleStore& particles, particles::Surroundings& surroundings,
                  const particles::Column& forces_x, double step);

    ProfileOptions options_;
    LinearElements elements_;
    std::vector<double> velocity_; ///< at the nodes, m/s
    std::vector<double> fraction_; ///< particles' volume fraction at the nodes
    std::vector<double> element_fraction_;
    std::vector<double> viscous_force_; ///< of mu du/dy at the nodes, N; 0 at the walls
    std::vector<double> couple_;        ///< of the particles on the fluid, by element, N m / m^3
    std::vector<double> drag_diagonal_, drag_beside_, drag_load_;
    std::vector<double> predicted_; ///< impulse of the drag by node that advance() counted with
    double momentum_gained_{};
    double wall_impulse_{};
};

} // namespace searle::solvers::suspension
