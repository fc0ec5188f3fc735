#pragma once

#include <cmath>

namespace searle::rheometry {

// Shear rate at the bob from the slope N = d ln omega / d ln tau_bob of the measured curve. All
// rest on 2 tau domega/dtau = rate(tau_bob) - rate(tau_cup), tau_cup = tau_bob / delta^2, which
// holds for every fluid in a gap whose cup is at rest (docs/conversion.md). omega in rad/s, > 0; N
// > 0; delta = R_cup / R_bob > 1; rates in 1/s.

/// t / (1 - exp(-t)), t >= 0, without cancellation at small t.
[[nodiscard]] inline double bernoulli_ratio(double t) {
    return t == 0.0 ? 1.0 : t / -std::expm1(-t);
}

/// Second derivative of bernoulli_ratio.
[[nodiscard]] inline double bernoulli_ratio_curvature(double t) {
    if (t < 0.1) {
        const double square = t * t;
        return 1.0 / 6.0 - square * (1.0 / 60.0 - square / 1008.0);
    }
    const double decay = std::exp(-t);
    const double rest = -std::expm1(-t);
    return decay * (t * (1.0 + decay) - 2.0 * rest) / (rest * rest * rest);
}

/// Gap sheared from wall to wall, power law near this stress: 2 omega N / (1 - delta^(-2 N)).
/// Exact for a power law; Newtonian: N = 1.
[[nodiscard]] inline double power_law_bob_rate(double omega, double slope, double delta) {
    const double log_ratio = std::log(delta);
    return omega / log_ratio * bernoulli_ratio(2.0 * slope * log_ratio);
}

/// What a slope that changes with the stress adds to power_law_bob_rate, to first order in
/// slope_change = dN / d ln tau. Krieger 1968, Trans. Soc. Rheol. 12, 5.
[[nodiscard]] inline double slope_change_correction(double omega, double slope, double slope_change,
                                                    double delta) {
    const double log_ratio = std::log(delta);
    return 2.0 * omega * slope_change * log_ratio *
           bernoulli_ratio_curvature(2.0 * slope * log_ratio);
}

/// Fluid at rest next to the cup (tau_cup below the yield stress): 2 omega N, exact for every
/// fluid.
[[nodiscard]] inline double partly_sheared_bob_rate(double omega, double slope) {
    return 2.0 * omega * slope;
}

} // namespace searle::rheometry
