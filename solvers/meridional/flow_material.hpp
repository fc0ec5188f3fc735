#pragma once

#include "geometry/din_bob.hpp"
#include "laws/flow/flow_law.hpp"
#include "solvers/axisymmetric/swirl_law.hpp"
#include "solvers/meridional/flow_system.hpp"

#include <memory>

namespace searle::solvers::meridional {

/// A fluid at one speed of the rotor in the units of FlowSystem: lengths over the bob's radius,
/// rates over the speed, stresses over stress_scale().
class ScaledFluid {
public:
    /// @param speed     rad/s, > 0
    /// @param wall_rate a typical shear rate, 1/s, > 0
    /// @param density   kg/m^3, >= 0
    /// @param rounding  of the yield surface and of the corner that a power law has at rest, as a
    ///                  share of wall_rate (SwirlLaw::RoundedPotential), > 0; no part in a
    ///                  Newtonian fluid
    ScaledFluid(const laws::flow::AnyFlowLaw& law, double density, double radius, double speed,
                double wall_rate, double rounding);

    /// With its inertia, or with a share of it, 0 for creeping flow.
    [[nodiscard]] FlowMaterial material(double inertia_share = 1.0) const {
        return {.law = *density_, .reynolds = inertia_share * inertia_};
    }
    [[nodiscard]] double stress_scale() const { return law_->stress_scale(); } ///< Pa
    /// omega R^2 density / viscosity, the viscosity at the typical shear rate.
    [[nodiscard]] double reynolds() const { return reynolds_; }

private:
    std::unique_ptr<axisymmetric::SwirlLaw> law_; ///< density_ refers to it
    std::unique_ptr<axisymmetric::EnergyDensity> density_;
    double inertia_; ///< density (speed radius)^2 / stress_scale
    double reynolds_;
};

} // namespace searle::solvers::meridional
