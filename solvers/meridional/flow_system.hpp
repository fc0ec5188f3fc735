#pragma once

#include "solvers/axisymmetric/energy_minimiser.hpp"
#include "solvers/meridional/flow_space.hpp"

#include <Eigen/Core>
#include <memory>

namespace searle::solvers::meridional {

/// What the flow obeys: the flow law over its stress scale as a function of the rate over the
/// rotor's speed, and inertia against that stress.
struct FlowMaterial {
    const axisymmetric::EnergyDensity& law;
    /// density (speed radius)^2 / stress scale; for a Newtonian fluid omega R^2 / nu. >= 0
    double reynolds{};
};

/// Momentum and continuity that a state leaves over, tested with the local functions, over
/// stress scale x radius^2 (rotation: x radius^3) without the 2 pi of the full angle.
struct FlowResidual {
    /// (node, component). At prescribed components: what the boundary has to supply, i.e. force
    /// and, for rotation, torque by the wall on the fluid.
    Eigen::MatrixX3d momentum;
    Eigen::MatrixXd continuity; ///< (pressure function, element)
};

/// The incompressible flow of a generalised Newtonian fluid with swirl, the same at every angle
/// (docs/secondary-flow.md, equations 1-4), as a system of equations on a FlowSpace.
class FlowSystem {
public:
    explicit FlowSystem(const FlowSpace& space);
    ~FlowSystem();
    FlowSystem(const FlowSystem&) = delete;
    FlowSystem& operator=(const FlowSystem&) = delete;

    [[nodiscard]] FlowResidual residual(const FlowState& state, const FlowMaterial& material) const;

    /// Factorises the derivative of the residual at a state, plus `mass_rate` times the mass
    /// (reynolds x the inertia of the velocity; units: over the rotor's speed), and keeps it.
    /// False where it is singular.
    bool factorise(const FlowState& at, const FlowMaterial& material, double mass_rate = 0.0);

    /// The change of state whose linearised residual is -`residual`, by the factors kept.
    /// Prescribed values do not change.
    [[nodiscard]] FlowState newton_change(const FlowResidual& residual) const;

    /// Mass times a rate of change of velocity, (node, component) as in FlowResidual::momentum.
    [[nodiscard]] Eigen::MatrixX3d inertia(const Eigen::MatrixX3d& acceleration,
                                           double reynolds) const;

    [[nodiscard]] const FlowSpace& space() const { return space_; }
    [[nodiscard]] long factorisations() const { return factorisations_; }

private:
    struct Factors;
    const FlowSpace& space_;
    std::vector<Eigen::MatrixXd> stacked_;    ///< along_r, along_z, values of each element
    std::vector<Eigen::MatrixXd> divergence_; ///< (radial nodes then axial nodes, function)
    std::unique_ptr<Factors> factors_;
    long factorisations_{};
};

/// Torque that the rotor exerts on the fluid, over 2 pi stress scale radius^3: from the residual at
/// the rotor's nodes, which is far more accurate than the slope of the velocity at the wall.
[[nodiscard]] double rotor_torque(const FlowSpace& space, const FlowResidual& residual);

/// Largest |residual| of unknowns (not of prescribed values), for Newton's method.
[[nodiscard]] double unbalance(const FlowSpace& space, const FlowResidual& residual);

/// state + share x change.
void add(FlowState& state, const FlowState& change, double share);

} // namespace searle::solvers::meridional
