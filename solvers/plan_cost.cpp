#include "solvers/plan_cost.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers {
namespace {

/// Linear solves a time step, and seconds of one element in one solve, as measured.
struct LawCost {
    double solves_per_step;
    double element_solve;
};

struct CostOf {
    LawCost operator()(const laws::flow::Newtonian&) const { return {8.0, 8e-8}; }
    LawCost operator()(const laws::flow::Bingham&) const { return {16.0, 8e-8}; }
    LawCost operator()(const laws::flow::Casson&) const { return {20.0, 1e-7}; }
    LawCost operator()(const laws::flow::PowerLaw&) const { return {22.0, 3e-7}; }
    LawCost operator()(const laws::flow::HerschelBulkley&) const { return {22.0, 3e-7}; }
    // Their rate at a given stress is found by iteration.
    LawCost operator()(const laws::flow::CarreauYasuda&) const { return {24.0, 5e-6}; }
    LawCost operator()(const laws::flow::Cross&) const { return {24.0, 5e-6}; }
};

/// Times at which the speed or its slope jumps.
double corners(const rheometry::Protocol& protocol) {
    struct Count {
        std::size_t operator()(const rheometry::Ramp&) const { return 1; }
        std::size_t operator()(const rheometry::Steps& steps) const { return steps.speeds.size(); }
        std::size_t operator()(const rheometry::Segments& program) const {
            return program.segments.size();
        }
    };
    return static_cast<double>(std::visit(Count{}, protocol.program));
}

} // namespace

Cost radial_cost(const Scene& scene, const Forecast& forecast, bool transient) {
    const double gaps = std::holds_alternative<geometry::DoubleGap>(scene.instrument) ? 2.0 : 1.0;
    const auto rows = static_cast<double>(forecast.rows.size());
    const bool newtonian = std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
    const double steady_seconds = rows * gaps * (newtonian ? 1e-6 : 5e-6);
    if (!transient) {
        return {steady_seconds, static_cast<long>(rows)};
    }
    // From runs at accuracies of 1e-2 to 1e-6: elements, and steps after a corner, grow by this
    // factor with every digit.
    constexpr double growth_per_digit = 1.75;
    const double digits = std::max(1.0, -std::log10(scene.solver.accuracy));
    const double growth = std::pow(growth_per_digit, digits - 2.0);
    const double elements = 10.0 * growth;
    const double steps = 2.0 * rows + 7.0 * growth * corners(scene.protocol);
    const LawCost law = std::visit(CostOf{}, scene.fluid.law);
    const double seconds = gaps * elements * steps * law.solves_per_step * law.element_solve;
    return {steady_seconds + seconds, static_cast<long>(gaps * (4.0 * elements + 1.0))};
}

Cost axisymmetric_cost(const Scene& scene, const Forecast& forecast, bool transient,
                       bool secondary_flow) {
    // From runs at accuracies of 1e-3 to 1e-5: seconds of one solution, and their number.
    const bool newtonian = std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
    const bool power_law = std::holds_alternative<laws::flow::PowerLaw>(scene.fluid.law);
    const bool yields = laws::flow::yield_stress(scene.fluid.law) > 0.0;
    constexpr double growth_per_digit = 3.0;
    const double digits = std::max(1.0, -std::log10(scene.solver.accuracy));
    const double growth = std::pow(growth_per_digit, digits - 3.0);
    const double one = growth * (newtonian ? 0.02 : yields ? 0.25 : 0.1);
    constexpr double most_solutions = 17.0;
    const double solutions =
        newtonian || power_law
            ? 1.0
            : std::min(most_solutions, static_cast<double>(forecast.rows.size()));
    const double inertia = !transient  ? 0.0
                           : newtonian ? 2.0 * one
                           : yields    ? 15.0 * one
                                       : 8.0 * one;
    // Secondary flow, as measured at 1e-3: a run in time, a solution.
    const double secondary =
        !secondary_flow ? 0.0
        : transient     ? 6.0
                        : 0.4 * std::min(most_solutions, static_cast<double>(forecast.rows.size()));
    return {solutions * one + inertia + secondary,
            static_cast<long>((yields ? 5000.0 : 2000.0) * growth)};
}

} // namespace searle::solvers
