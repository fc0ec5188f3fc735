#pragma once

#include "laws/flow/flow_law.hpp"

namespace searle::verification {

/// Relative error of a computed stress tau at the inner wall of an annulus that turns at omega,
/// from an evaluation with 50 digits: omega(tau) = 1/2 integral of rate(q)/q dq over the STRESS q
/// by tanh-sinh quadrature (the solver integrates over ln(rate) in double with Gauss points), then
/// d tau / tau = (omega - omega(tau)) / [(rate_inner - rate_outer) / 2].
/// Laws without an explicit inverse are integrated over the rate, again with 50 digits.
/// @param delta_squared_minus_one  (outer / inner)^2 - 1
[[nodiscard]] double steady_stress_error(const laws::flow::AnyFlowLaw& law,
                                         double delta_squared_minus_one, double omega,
                                         double stress);

} // namespace searle::verification
