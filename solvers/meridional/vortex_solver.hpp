#pragma once

#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/scene.hpp"

namespace searle::solvers::meridional {

/// Torque history of a single or double gap whose rows go past the onset of Taylor vortices: the
/// laminar flow of solve_radial, and what axisymmetric vortices of the most unstable wavelength (or
/// solver.vortex_wavelength) add in the gap outside the rotor (docs/secondary-flow.md). In a steady
/// series each row has fully grown vortices; in time they grow from solver.disturbance.
/// @param scene  whose instrument is a ConcentricCylinders or a DoubleGap, without a yield stress
[[nodiscard]] radial::RadialReport solve_with_vortices(const Scene& scene, const Plan& plan,
                                                       const ProgressSink& progress);

/// For a gap past the onset whose vortices are not solved because the fluid has a yield stress: the
/// torque stays the laminar one, and its error grows by what they may add
/// (stability::vortex_torque_ratio). Leaves alone what was asked for without vortices
/// (solver.model = "radial", secondary_flow = false).
void doubt_vortices_left_out(const Scene& scene, const Plan& plan, radial::RadialReport& report);

} // namespace searle::solvers::meridional
