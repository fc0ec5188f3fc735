#pragma once

#include "rheometry/conversion/conversion.hpp"
#include "solvers/plan.hpp"

#include <vector>

namespace searle::solvers {

/// What the plan's sentences need to know about a row beside its forecast.
struct RowFacts {
    bool partly_sheared{};
    double yield_radius{};    ///< m, of the gap that the conversion is for; 0 for the box
    double rotor_wall_rate{}; ///< 1/s, true shear rate of the steady flow
    double reynolds{};        ///< R_bob omega d / nu with the full gap; box: U h / nu
    double end_reynolds{};    ///< omega R_bob^2 / nu
    double end_flow_share{};  ///< 0 for an instrument without ends
    /// Relative difference between the converted stress and the law's at the converted rate.
    double definition_error{};
};

/// Everything that the plan knows about the rows before it decides.
struct Forecast {
    rheometry::Conversion conversion;
    bool steady_series{}; ///< held until steady: no time dependence
    std::vector<RowForecast> rows;
    std::vector<RowFacts> facts; ///< same size
    std::optional<TaylorOnset> taylor;
};

/// Steady flow, inertia, stability and regime of every row.
[[nodiscard]] Forecast forecast(const Scene& scene);

/// End flow: estimated part of a bob's torque that is secondary flow at its ends. A fit to the
/// solved flow of a Newtonian fluid around the ISO 3219 bob (docs/secondary-flow.md), within 8 % of
/// it for Re 0 ... 1500; other gaps and lengths by the torque of the cylinder.
/// @param reynolds  omega R_bob^2 / nu
/// @param radius_ratio  cup over bob, > 1
/// @param length_ratio  wetted cylinder over R_bob, > 0
[[nodiscard]] double end_flow_share(double radius_ratio, double length_ratio, double reynolds);

} // namespace searle::solvers
