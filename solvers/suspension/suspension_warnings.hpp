#pragma once

#include "solvers/plan_forecast.hpp"
#include "solvers/scene.hpp"
#include "solvers/suspension/suspension_plan.hpp"

#include <string>
#include <vector>

namespace searle::solvers::suspension {

/// What the plan of a suspension has to warn of: what the level of hydrodynamics leaves out,
/// colloids that aggregate, contacts too soft or needlessly stiff, thermal motion left out.
[[nodiscard]] std::vector<std::string> warnings_for(const Scene& scene, const Forecast& forecast,
                                                    const SuspensionChoice& choice);

} // namespace searle::solvers::suspension
