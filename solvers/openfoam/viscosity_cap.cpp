#include "solvers/openfoam/viscosity_cap.hpp"

#include "laws/flow/flow_law.hpp"
#include "solvers/openfoam/convergence_plan.hpp"
#include "solvers/openfoam/transport.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::openfoam {
namespace {

/// Rate at which the viscosity reaches its cap, as a part of the slowest row's rate at the wall.
double cap_part(double accuracy) { return std::clamp(accuracy, 1e-6, 1e-2); }

/// The least rate at which the viscosity is no more than its cap: of a thickening fluid it may rise
/// beyond it again.
double rate_of_cap(const auto& viscosity, double cap, double typical_rate) {
    double low = std::log(1e-12 * typical_rate);
    const double end = std::log(1e12 * typical_rate);
    constexpr double stride = 0.1;
    double high = low;
    while (high < end && viscosity(std::exp(high)) > cap) {
        low = high;
        high += stride;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (viscosity(std::exp(middle)) > cap ? low : high) = middle;
    }
    return std::exp(high);
}

} // namespace

void choose_cap(const Scene& scene, const Plan& plan, FoamPlan& foam) {
    foam.cap_error.assign(plan.rows.size(), 0.0);
    if (!needs_viscosity_cap(scene.fluid.law))
        return;
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = 0.0;
    for (const RowForecast& row : plan.rows)
        if (row.shear_rate != 0.0) {
            slowest = std::min(slowest, std::abs(row.shear_rate));
            fastest = std::max(fastest, std::abs(row.shear_rate));
        }
    if (!std::isfinite(slowest))
        slowest = fastest = 1.0;
    const auto viscosity = [&](double rate) {
        return laws::flow::stress(scene.fluid.law, rate) / rate;
    };
    // Of a thickening fluid that of the fastest fluid counts, which may be more.
    constexpr double margin = 2.0;
    const double least = margin * viscosity(margin * fastest);
    foam.viscosity_cap = scene.solver.viscosity_cap.value_or(
        std::max(viscosity(cap_part(scene.solver.accuracy) * slowest), least));
    const double cap_rate = rate_of_cap(viscosity, foam.viscosity_cap, slowest);
    // A cap lowers the torque by 0.22 of cap rate over wall rate where there is a plug
    // (physics of a gap of 1.5; measured); more is claimed.
    // In time the creep of the plug counts twice where the flow turns round: 0.98 was seen.
    const double claimed = foam.steady ? 0.5 : 1.25;
    // Around a rotor's ends a part of the fluid is at rest whatever the gap does; what creeps there
    // is worth as much of the ends' torque, a quarter of the whole at the most.
    constexpr double share_of_ends = 0.25;
    const bool rests_at_ends = scene.profile || geometry::has_ends(scene.instrument);
    for (std::size_t row = 0; row < plan.rows.size(); ++row) {
        const double rate = std::abs(plan.rows[row].shear_rate);
        // Of a double gap the inner one is sheared less than the one outside of the rotor.
        const bool in_gap =
            plan.rows[row].regime.find("partly-sheared") != std::string::npos ||
            (rate != 0.0 && least_rate(scene, plan.rows[row].speed) < 10.0 * cap_rate);
        // Nothing tells what a cap below the viscosity of what is sheared does.
        if (rate != 0.0 && viscosity(rate) > foam.viscosity_cap)
            foam.cap_error[row] = 1.0;
        else if (in_gap || rests_at_ends)
            foam.cap_error[row] =
                std::min(1.0, (in_gap ? 1.0 : share_of_ends) * claimed * cap_rate / rate);
    }
}

} // namespace searle::solvers::openfoam
