#pragma once

#include "solvers/openfoam/foam_plan.hpp"

namespace searle::solvers::openfoam {

/// Sets the viscosity that fluid at rest gets where its law has no bound there, and what each row
/// claims as error for it.
/// @param plan  of the same scene: rows and regimes
void choose_cap(const Scene& scene, const Plan& plan, FoamPlan& foam);

} // namespace searle::solvers::openfoam
