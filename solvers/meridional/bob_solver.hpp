#pragma once

#include "solvers/axisymmetric/axisymmetric_solver.hpp"
#include "solvers/axisymmetric/end_effect_table.hpp"

namespace searle::solvers::meridional {

/// Torque history of a DIN bob with its ends: the swirl of solve_axisymmetric, and where the plan
/// says so the secondary flow (u_r, u_z, p) with it (docs/secondary-flow.md). Steady rows: the
/// creeping flow's torque times what secondary flow adds at that speed. Rows in time, where the
/// plan found inertia: one run of the whole flow.
/// @param scene  whose instrument has ends; around a double gap swirl alone
[[nodiscard]] axisymmetric::AxisymmetricReport solve_bob(const Scene& scene, const Plan& plan,
                                                         const ProgressSink& progress);

/// End factors of creeping flow and, around a bob unless secondary_flow = false, with the steady
/// secondary flow.
/// @param scene   whose instrument has ends
/// @param speeds  rad/s, > 0
[[nodiscard]] axisymmetric::EndEffectTable
end_effects(const Scene& scene, std::span<const double> speeds, const ProgressSink& progress);

} // namespace searle::solvers::meridional
