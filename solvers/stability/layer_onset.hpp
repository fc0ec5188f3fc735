#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"

namespace searle::solvers::stability {

/// Where the steady flow of any fluid between a turning bob and a cup at rest, at one speed, loses
/// its stability to axisymmetric, steady Taylor vortices: as the density that the fluid would need.
/// The flow without a secondary one does not depend on the density, so the linear problem is one
/// for it; a fluid of density rho is past the onset where rho is more. For a Newtonian fluid
/// rho over this is Re / Re_c.
struct LayerOnset {
    /// kg/m^3; infinite when no density makes the flow unstable
    double critical_density{};
    /// Re = rho R_bob omega d / eta at that density, d the whole gap, eta the viscosity at the bob
    double reynolds{};
    double wave_number{};    ///< axial wave number times d at the onset
    double relative_error{}; ///< of both numbers above: difference of the last two resolutions
    int modes{};             ///< functions per unknown of the last resolution
};

/// The linear problem of docs/plan.md, section Taylor vortices: the disturbance's stress has the
/// tangent viscosity in the (r, theta) component and the secant one in all others; minimised over
/// the wave number, at rising resolution.
/// About 1 ms at a tolerance of 1e-4.
/// @param speed      rad/s, > 0
/// @param tolerance  asked relative error, > 0
[[nodiscard]] LayerOnset layer_onset(const radial::AnnularGap& gap,
                                     const laws::flow::AnyFlowLaw& law, double speed,
                                     double tolerance);

/// The same at one resolution; relative_error is 0. For convergence studies.
/// @param modes  functions per unknown, >= 4
[[nodiscard]] LayerOnset layer_onset_with_modes(const radial::AnnularGap& gap,
                                                const laws::flow::AnyFlowLaw& law, double speed,
                                                int modes);

/// Upper bound of rho gamma d^2 / (2 pi^2 mu), the energy that a disturbance can draw from the flow
/// over what it must dissipate (Serrin 1959, Arch. Rational Mech. Anal. 3, 1, with the smallest of
/// all secant and tangent viscosities in the layer and the largest rate): up to 1 no axisymmetric
/// disturbance grows.
/// @param density  kg/m^3
[[nodiscard]] double energy_ratio(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                                  double speed, double density);

} // namespace searle::solvers::stability
