#pragma once

#include "rheometry/end_effect.hpp"
#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/scene.hpp"

#include <vector>

namespace searle::solvers::axisymmetric {

/// What came out: the same data as from the radial solver, and the end effect at each row.
struct AxisymmetricReport {
    radial::RadialReport solution;
    /// c_L of the creeping flow at the row's speed; 1 at rest. One per row.
    std::vector<double> end_factor;
    /// The same with errors and bounds, of the rows that turn.
    std::vector<rheometry::EndEffect> ends;
};

/// Torque history of a DIN bob with its ends, swirl only: steady rows of any flow law, and a
/// Newtonian fluid's inertia in the whole section. What is left out (secondary flow; the inertia of
/// another fluid) is added to the rows' errors as large as the plan estimates it, unless the case
/// says solver.model = "axisymmetric" or secondary_flow = false.
/// @param scene  whose instrument has ends (section_shape)
[[nodiscard]] AxisymmetricReport solve_axisymmetric(const Scene& scene, const Plan& plan,
                                                    const ProgressSink& progress);

} // namespace searle::solvers::axisymmetric
