#pragma once

#include "solvers/meridional/flow_level.hpp"
#include "solvers/progress.hpp"

#include <complex>

namespace searle::solvers::meridional {

/// The axisymmetric disturbance of a steady flow that grows fastest or decays most slowly.
struct LeadingDisturbance {
    /// exp(rate x time): growth in the real part, angular frequency in the imaginary one (>= 0);
    /// both over the rotor's speed.
    std::complex<double> rate;
    double residual{}; ///< of the eigenvalue problem, over |1 / (shift - rate)|; small: converged
};

/// The eigenvalue with the largest real part among those next to a positive shift, by Arnoldi's
/// method on the inverse of (derivative + shift x mass).
/// @param level   its state is the steady flow of `material`; its factors are replaced
/// @param vectors  of the Krylov space at most; fewer where further ones bring nothing
/// May throw Interrupted.
/// @return a rate of -infinity where no eigenvalue converged
[[nodiscard]] LeadingDisturbance leading_disturbance(FlowLevel& level, const FlowMaterial& material,
                                                     const ProgressSink& progress = {},
                                                     int vectors = 80);

} // namespace searle::solvers::meridional
