#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"

namespace searle::verification {

/// Marginal density of the steady flow between a turning bob and a cup at rest, and the axial wave
/// number (1/m) at which it is least.
struct ShotOnset {
    double density{};
    double wave_number{};
};

/// An independent method for the onset of axisymmetric vortices in any fluid: the linearised
/// equations in strong form as six of first order (u, w, S, Q, v, T: velocities, shear stress in
/// (r, z), -(normal stress in r), swirl, shear stress in (r, theta)), three solutions shot from the
/// bob by the classical Runge-Kutta method in 2000 steps, and the density at which the determinant
/// of their three velocities at the outer end vanishes. Own quadrature for the steady flow. Shares
/// neither unknowns, nor functions, nor boundary treatment with solvers/stability. A yield surface
/// is taken for a wall at 1e-6 of the layer's width before it.
/// @param density, wave_number  near the answer: the density is searched from half to twice, the
///                              wave number within 5 %
/// @throws std::runtime_error when there is no root
[[nodiscard]] ShotOnset shooting_onset(const solvers::radial::AnnularGap& gap,
                                       const laws::flow::AnyFlowLaw& law, double speed,
                                       double density, double wave_number);

/// Density at which a disturbance that runs around the bob, exp(i m theta), becomes marginal: least
/// over the axial wave number. The same equations in complex numbers, Newton's method in density
/// and phase speed, followed from m = 1/8 in steps of 1/8.
/// @param order         m >= 1
/// @param axisymmetric  shooting_onset of the same flow
/// @throws std::runtime_error when Newton's method finds nothing
[[nodiscard]] double running_wave_density(const solvers::radial::AnnularGap& gap,
                                          const laws::flow::AnyFlowLaw& law, double speed,
                                          int order, const ShotOnset& axisymmetric);

} // namespace searle::verification
