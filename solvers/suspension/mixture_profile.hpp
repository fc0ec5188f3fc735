#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/suspension/fluid_profile.hpp"
#include "solvers/suspension/linear_elements.hpp"
#include "solvers/suspension/lubrication_pairs.hpp"

#include <vector>

namespace searle::solvers::suspension {

struct MixtureProfileOptions {
    double gap{};         ///< m
    double wall_area{};   ///< m^2
    int cells{};          ///< across the gap, >= 1
    double viscosity{};   ///< of the fluid, Pa s
    double density{};     ///< of the fluid, kg/m^3
    double length_unit{}; ///< m, of Motion's rotations
};

/// The volume-averaged flow between two walls, u(y) along x, for particles that have no inertia of
/// their own: as FluidProfile has it with stresslets, but solved for together with their motion,
///     rho_m du/dt = d/dy(mu (1 + 2.5 phi) du/dy) - drag on particles + curl of their couples / 2.
/// rho_m is the mixture's density: the particles' mass moves with the fluid around them. Linear
/// elements, implicit Euler. The flow follows the particles at once: u = T^-1 (f + P^T D V), V
/// their motion, D their drag, P the elements' weights at them, T = M/step + K + P^T D P
/// tridiagonal. In the particles' balance that leaves one symmetric positive definite system for
/// them alone,
///     (D + R - D P T^-1 P^T D) V = F + D P T^-1 f,
/// of which this class adds the terms of the fluid. Motions are those beside the mean shear.
class MixtureProfile {
public:
    explicit MixtureProfile(const MixtureProfileOptions& options);

    /// Uniform shear with the upper wall at `wall_speed`.
    void set_uniform_shear(double wall_speed);

    /// Takes the places of the particles for a step, and their drags, which must stay until its
    /// end; factorises.
    /// @param drag         Stokes' drag, N s/m  @param turning_drag over the length unit's square
    /// @param shear_rate   of the mean shear in the middle of the step, 1/s  @param step s
    void prepare(const particles::ParticleStore& particles, const particles::Column& drag,
                 const particles::Column& turning_drag, double shear_rate, double step);

    /// Adds D P T^-1 f: what the fluid does to particles that move with the mean shear.
    void add_load(Motions& forces);
    /// Subtracts D P T^-1 P^T D V.
    void subtract_response(const Motions& motions, Motions& forces);

    /// Ends the step with the flow that belongs to the motions.
    void follow(const Motions& motions);
    /// Of the last step's flow, beside the mean shear, where a particle was, m/s.
    [[nodiscard]] double velocity_at(std::size_t particle) const;
    /// Largest shear rate in an element, 1/s, >= 0.
    [[nodiscard]] double steepest_rate() const;
    /// Of the last step: what the drive has to supply at the moving wall, but for films and
    /// contacts with the wall.
    [[nodiscard]] WallShear wall_shear(const Motions& motions) const;
    /// Of the last step: mean over the gap of 2.5 phi mu du/dy, Pa.
    [[nodiscard]] double mean_stresslet() const;
    /// At the nodes from wall to wall, with the mean shear, m/s; all that a checkpoint needs.
    [[nodiscard]] const std::vector<double>& velocity() const { return velocity_; }
    void restore(const std::vector<double>& velocity) { velocity_ = velocity; }

private:
    /// Sums P^T D V over the nodes; P holds the rotations' weights, too.
    void gather(const Motions& motions, std::vector<double>& load) const;
    /// Subtracts (or with a factor of -1 adds) D P w.
    void spread(const std::vector<double>& beside, double factor, Motions& forces) const;
    /// T w = load, in place; 0 at the walls.
    void solve(std::vector<double>& load) const;

    MixtureProfileOptions options_;
    LinearElements elements_;
    double shear_rate_{};
    const particles::Column* drag_{};
    const particles::Column* turning_drag_{};
    std::vector<LinearElements::Place> place_; ///< of each particle
    std::vector<double> fraction_;             ///< particles' volume in an element over its own
    std::vector<double> pivot_, ratio_;        ///< T = L D L^T
    std::vector<double> load_;                 ///< f
    std::vector<double> scratch_;
    std::vector<double> beside_;   ///< the flow beside the mean shear, at the nodes
    std::vector<double> velocity_; ///< with it
    double wall_inertia_{};        ///< force that the mass at the moving wall takes, N
};

} // namespace searle::solvers::suspension
