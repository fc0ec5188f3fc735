#pragma once

#include "app/stress/draw.hpp"
#include "app/stress/random_case.hpp"

namespace searle::app {

[[nodiscard]] RandomCase fluid_case(Draw& draw);
/// The same beyond what anybody would measure: Bingham numbers to 10^6, times from a millionth of
/// the gap's own.
[[nodiscard]] RandomCase extreme_case(Draw& draw);
/// Scenes of the same kinds for OpenFOAM, half of them with a time step and cells forced on it.
[[nodiscard]] RandomCase openfoam_case(Draw& draw);
[[nodiscard]] RandomCase particle_case(Draw& draw);
/// A fluid case with its text mangled: bytes, lines, numbers, units.
[[nodiscard]] RandomCase input_case(Draw& draw);

} // namespace searle::app
