#pragma once

namespace searle::solvers::suspension {

/// Longest step, s, at which a particle on a spring does not swing up when the drag is exact and
/// the spring's force is held within the step (particles::move_with_exact_drag). Relaxation time
/// tau = mass / drag, a = exp(-h / tau), kappa = stiffness / drag; a step is
///     v -> a v - (1 - a) kappa x,  x -> x + tau (1 - a) v - (h - tau (1 - a)) kappa x,
/// whose eigenvalues stay within the unit circle while (Jury)
///     kappa (A (1 + a) - B) < 2 (1 + a)  and  kappa (B - a A) < 1 - a,
/// A = h - tau (1 - a), B = tau (1 - a)^2. Without mass 2 / kappa.
/// @param stiffness N/m, > 0 (of two equal particles against each other: twice the contact's)
/// @param mass kg, > 0  @param drag kg/s, > 0
[[nodiscard]] double longest_stable_step(double stiffness, double mass, double drag);

} // namespace searle::solvers::suspension
