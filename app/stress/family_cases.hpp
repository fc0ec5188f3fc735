#pragma once

#include "app/stress/draw.hpp"
#include "app/stress/random_case.hpp"

namespace searle::app {

[[nodiscard]] RandomCase fluid_case(Draw& draw);
[[nodiscard]] RandomCase particle_case(Draw& draw);
/// A fluid case with its text mangled: bytes, lines, numbers, units.
[[nodiscard]] RandomCase input_case(Draw& draw);

} // namespace searle::app
