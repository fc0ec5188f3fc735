#pragma once

namespace searle::solvers::stability {

/// About how many times the laminar torque Taylor vortices and, far past the onset, turbulence
/// carry between an inner cylinder that turns and an outer one at rest. Up to a few times the onset
/// 1 + 1.5 (1 - 1/r^2) (the amplitude of weakly nonlinear theory in a narrow gap: Davey 1962, J.
/// Fluid Mech. 14, 336), beyond it the torques that Wendt (1933, Ing.-Arch. 4, 577) measured,
///   G = T / (rho nu^2 L) = 1.45 eta^(3/2) / (1 - eta)^(7/4) Re^1.5 up to Re = 1e4, 0.23 .. Re^1.7
/// from there on, eta = R_i / R_o, Re = R_i omega d / nu. An estimate for what is not solved:
/// within 15 % of his data for eta 0.68 to 0.94, of unknown error elsewhere and for fluids that are
/// not Newtonian.
/// @param relative_gap  d / R_i, > 0
/// @param ratio         Re over its critical value; up to 1 the answer is 1
[[nodiscard]] double vortex_torque_ratio(double relative_gap, double ratio);

} // namespace searle::solvers::stability
