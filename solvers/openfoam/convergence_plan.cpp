#include "solvers/openfoam/convergence_plan.hpp"

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace searle::solvers::openfoam {
namespace {

bool is_newtonian(const Scene& scene) {
    return std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
}

/// Least stress in the gap over the largest at the rotor.
double stress_span(const geometry::Instrument& instrument) {
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return std::pow(gap->bob_radius / gap->cup_radius, 2);
    if (const auto* gap = std::get_if<geometry::DoubleGap>(&instrument))
        return std::pow(gap->radii[0] / gap->radii[1] * gap->radii[2] / gap->radii[3], 2);
    return 1.0;
}

/// d ln stress / d ln rate.
double slope_at(const laws::flow::AnyFlowLaw& law, double rate) {
    constexpr double step = 1e-3; // of ln rate
    return std::log(laws::flow::stress(law, rate * std::exp(step)) /
                    laws::flow::stress(law, rate * std::exp(-step))) /
           (2.0 * step);
}

constexpr long most_iterations = 3000;
constexpr long enough_with_plug = 2000;
constexpr long fewest_iterations = 10;

/// Iterations of a row whose rotor turns at `speed`; 0 where they would not converge.
long iterations_at(const Scene& scene, double speed) {
    if (is_newtonian(scene) || speed == 0.0)
        return fewest_iterations;
    const laws::flow::AnyFlowLaw& law = scene.fluid.law;
    const radial::SteadyInstrumentFlow flow =
        radial::steady_instrument_flow(scene.instrument, law, speed);
    const double largest = laws::flow::stress(law, flow.rotor_wall_rate);
    const double least = stress_span(scene.instrument) * largest;
    if (flow.partly_sheared || least <= laws::flow::yield_stress(law))
        return enough_with_plug;
    double left = 0.0; // of an error, after an iteration
    constexpr int parts = 8;
    for (int part = 0; part <= parts; ++part) {
        const double stress = least * std::pow(largest / least, static_cast<double>(part) / parts);
        left = std::max(left, std::abs(1.0 - slope_at(law, laws::flow::rate(law, stress))));
    }
    constexpr double hardly = 0.99;
    if (left > hardly && slope_at(law, flow.rotor_wall_rate) > 1.0)
        return 0;
    constexpr double aim = 1e-9;
    constexpr double margin = 1.3;
    const double count = margin * std::log(aim) / std::log(std::clamp(left, 1e-3, 1.0 - 1e-9));
    return std::clamp(std::lround(std::ceil(count)), fewest_iterations, most_iterations);
}

} // namespace

void choose_corrections(const Scene& scene, FoamPlan& foam) {
    const bool is_rate_dependent = !is_newtonian(scene);
    if (foam.swirl_alone) {
        // A wedge takes the turn of the velocity from side to side from the correction before, and
        // the second has it to 1e-5 (measured). A viscosity that falls with the rate is found by
        // repeated substitution, which gains little each time.
        const bool is_box = std::holds_alternative<geometry::Box>(scene.instrument);
        foam.outer_corrections = is_rate_dependent ? 6 : is_box ? 1 : 2;
        return;
    }
    // SIMPLEC's pressure equation has its coefficients from what a row of the matrix has left over,
    // which far beyond the cells' diffusion times is next to nothing: without relaxation the
    // corrections diverge (oil around a DIN bob). Vortices grow only where inertia outweighs that;
    // what relaxation leaves behind would cost them 1 % of the torque (10 cells across).
    if (foam.vortices && !is_rate_dependent)
        foam.outer_corrections = 2;
    else
        foam.relaxation = 0.9;
}

std::vector<long> row_ends(const Scene& scene, const std::vector<double>& speeds) {
    std::vector<long> ends;
    long end = 0;
    for (const double speed : speeds) {
        const long iterations = iterations_at(scene, speed);
        if (iterations == 0)
            return {};
        end += iterations;
        ends.push_back(end);
    }
    return ends;
}

} // namespace searle::solvers::openfoam
