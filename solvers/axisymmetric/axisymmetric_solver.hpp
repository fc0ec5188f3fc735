#pragma once

#include "rheometry/end_effect.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/scene.hpp"

#include <span>
#include <vector>

namespace searle::solvers::axisymmetric {

/// What came out: the same data as from the radial solver, and the end effect at each row.
struct AxisymmetricReport {
    radial::RadialReport solution;
    /// c_L of the creeping flow at the row's speed; 1 at rest. One per row.
    std::vector<double> end_factor;
    /// Of the mesh that the torques come from; without lines when every row is at rest.
    SectionDivision division;
    /// The same with errors and bounds, of the rows that turn.
    std::vector<rheometry::EndEffect> ends;
};

/// Puts the torques of a run in time in place of the steady ones; rows that it did not finish go.
/// @param error  one per torque, N m
void fill_from_run(std::span<const double> torque, std::span<const double> error,
                   AxisymmetricReport& report);

/// Torque history of an instrument with its ends, swirl only: steady rows, or rows with the inertia
/// in the whole section, of any flow law. What is left out (secondary flow; inertia that the plan
/// found small) is added to the rows' errors as large as the plan estimates it, unless the case
/// says solver.model = "axisymmetric" or secondary_flow = false.
/// @param scene  whose instrument has ends (section_shape)
[[nodiscard]] AxisymmetricReport solve_axisymmetric(const Scene& scene, const Plan& plan,
                                                    const ProgressSink& progress);

} // namespace searle::solvers::axisymmetric
