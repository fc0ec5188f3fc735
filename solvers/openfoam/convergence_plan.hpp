#pragma once

#include "solvers/openfoam/foam_plan.hpp"

#include <algorithm>
#include <vector>

namespace searle::solvers::openfoam {

/// The law's n: where it has one d ln stress / d ln rate far from its bends, else 1.
[[nodiscard]] double flow_index_of(const laws::flow::AnyFlowLaw& law);

/// The least rate of shear in any gap of the instrument, ends left out, 1/s, >= 0; 0 with a plug. A
/// double gap's inner gap counts by a bound.
/// @param speed  of the rotor, steady, != 0
[[nodiscard]] double least_rate(const Scene& scene, double speed);

/// What a steady row may still move when its residual ends it, over its torque: a twentieth of the
/// accuracy, and half of what the balance of its two torques may lack (0.2 %).
[[nodiscard]] constexpr double unsettled_part(double accuracy) {
    return 0.05 * std::min(accuracy, 0.02);
}

/// Sets how often the corrections of a time step are repeated, the relaxation, and the residual
/// with which a steady row ends.
/// @param foam  with steady, swirl_alone and vortices
void choose_corrections(const Scene& scene, const Plan& plan, FoamPlan& foam);

/// Steady rows of the swirl alone, where each iteration puts in the viscosity of the one before and
/// solves for the swirl: where the stress goes as the s-th power of the rate an error shrinks to |1
/// - s| of itself each time. As many iterations a row as bring it to 1e-4 of the accuracy, from the
/// steady flow's rates; where there is a plug as many as were enough.
/// @param foam  with speeds and skew_cells
/// @return the iteration with which each row ends
[[nodiscard]] std::vector<long> row_ends(const Scene& scene, const FoamPlan& foam);

} // namespace searle::solvers::openfoam
