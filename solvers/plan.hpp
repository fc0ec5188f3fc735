#pragma once

#include "solvers/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::solvers {

/// One thing that the plan leaves out or brings in, with the number that decided.
struct PlanItem {
    std::string what;   ///< "inertia", "ends", "Taylor vortices", "mesh", ...
    bool solved{};      ///< false: skipped
    std::string reason; ///< a full sentence that holds the number
};

/// Onset of Taylor vortices for a cup at rest, with Re = R_bob omega d / nu.
struct TaylorOnset {
    double critical_reynolds{};
    /// Largest Re of the protocol; for a non-Newtonian fluid with the viscosity of `basis`.
    double reynolds{};
    /// Axial wave number times gap at the onset.
    double wave_number{};
    std::string basis;
};

/// What holds at one row of the result.
struct RowForecast {
    double time{};
    double speed{};
    double shear_rate{};
    double steady_stress{};
    std::string regime; ///< names joined by '+': laminar, rest, partly-sheared, lag, taylor-vortices, end-flow
    double taylor_ratio{}; ///< Re / Re_critical
    double lag_share{};    ///< estimated relative part of the stress that is inertia
};

struct Plan {
    std::string model;        ///< "radial steady", "radial transient", ...
    std::string model_reason;
    bool transient{};
    bool can_be_solved = true; ///< false: nothing in this program solves it yet; model_reason says why
    std::vector<PlanItem> items;
    std::optional<TaylorOnset> taylor;
    std::vector<RowForecast> rows;
    std::vector<std::string> warnings;
    double expected_seconds{};
    long expected_unknowns{};
};

/// Plans a scene without solving its time dependence. Cost: milliseconds (a steady solve per row).
[[nodiscard]] Plan make_plan(const Scene& scene);

} // namespace searle::solvers
