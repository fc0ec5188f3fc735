#pragma once

#include "solvers/plan_forecast.hpp"

#include <string>
#include <vector>

namespace searle::solvers {

/// What the choice of the model comes to.
struct PlannedModel {
    bool radial = true;
    bool transient{};
    bool secondary_flow{};
    bool vortices{};
};

/// What the plan solves and what it skips, each with its number.
[[nodiscard]] std::vector<PlanItem> plan_items(const Scene& scene, const Forecast& forecast,
                                               PlannedModel model);

/// What the user should know before believing the result.
/// @param vortices  Plan::vortices
[[nodiscard]] std::vector<std::string> plan_warnings(const Scene& scene, const Forecast& forecast,
                                                     bool vortices);

} // namespace searle::solvers
