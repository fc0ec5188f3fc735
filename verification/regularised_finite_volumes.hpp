#pragma once

#include "laws/flow/herschel_bulkley.hpp"

#include <functional>
#include <vector>

namespace searle::verification {

/// An independent method for the transient flow of a yield-stress fluid in an annulus whose inner
/// wall turns: primal finite volumes in the angular velocity on a uniform grid, the stress
/// regularised as tau = tau0 rate/sqrt(rate^2 + e^2) + K |rate|^(n-1) rate, implicit Euler with
/// fixed steps, Newton on the velocities. First order in the step, second in the cell, first in e:
/// shares neither unknowns, nor grid, nor time scheme, nor treatment of the yield stress with
/// solvers/radial.
struct FiniteVolumeScene {
    double inner{}, outer{}, density{};
    laws::flow::HerschelBulkley law;
    std::function<double(double)> speed; ///< rad/s of the inner wall over time, 0 at time 0
};

/// Stress at the inner wall (magnitude and sign of the drive's effort, Pa) at the given times,
/// which are multiples of `step`.
[[nodiscard]] std::vector<double> regularised_wall_stress(const FiniteVolumeScene& scene,
                                                          const std::vector<double>& times,
                                                          int cells, double step,
                                                          double regularisation);

} // namespace searle::verification
