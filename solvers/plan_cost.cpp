#include "solvers/plan_cost.hpp"

#include <cmath>

namespace searle::solvers {

Cost radial_cost(const Scene& scene, const Forecast& forecast, bool transient) {
    const bool newtonian = std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
    const double gaps = std::holds_alternative<geometry::DoubleGap>(scene.instrument) ? 2.0 : 1.0;
    const auto rows = static_cast<double>(forecast.rows.size());
    constexpr double steady_solve = 1.5e-5; // s, of one gap at one speed
    const double steady_seconds = rows * gaps * (newtonian ? 0.2 : 1.0) * steady_solve;
    if (!transient) {
        return {steady_seconds, static_cast<long>(rows)};
    }
    // Elements and steps of the finest level grow with the accuracy's powers that belong to the
    // orders of the discretisation; a yield surface or a singular law costs further digits.
    const double digits = std::max(1.0, -std::log10(scene.solver.accuracy));
    const bool yields = laws::flow::yield_stress(scene.fluid.law) > 0.0;
    const double elements = (newtonian ? 3.0 : 8.0) * std::pow(newtonian ? 1.35 : 1.8, digits);
    const double steps = std::max(rows, (newtonian ? 8.0 : 30.0) * std::pow(2.0, digits));
    const double stages = newtonian ? 5.0 : 18.0;
    const double element_solve = newtonian ? 4e-8 : (yields ? 4e-7 : 3e-7); // s
    return {steady_seconds + 2.0 * gaps * elements * steps * stages * element_solve,
            static_cast<long>(gaps * elements * 4.0)};
}

} // namespace searle::solvers
