#include "solvers/openfoam/convergence_plan.hpp"

#include "laws/flow/flow_law.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace searle::solvers::openfoam {
namespace {

struct RateSpan {
    double least, largest; ///< in all gaps, over the rate at the rotor's (outer) wall
};

/// Of a fluid whose stress falls as 1 / r^2; the rates of a double gap's inner gap are taken to be
/// to those of the outer one as a Newtonian fluid's are, within a half.
double rate_over_speed(double inner, double outer) {
    return 2.0 * outer * outer / (outer * outer - inner * inner);
}

RateSpan span_of(const geometry::Instrument& instrument, const laws::flow::AnyFlowLaw& law,
                 double rate) {
    const auto across = [&law](double at, double stress_ratio) {
        const double stress = stress_ratio * laws::flow::stress(law, at);
        return stress <= laws::flow::yield_stress(law) ? 0.0 : laws::flow::rate(law, stress);
    };
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return {across(rate, std::pow(gap->bob_radius / gap->cup_radius, 2)), rate};
    if (const auto* gap = std::get_if<geometry::DoubleGap>(&instrument)) {
        const auto& r = gap->radii;
        const double outer_end = across(rate, std::pow(r[2] / r[3], 2));
        const double at_post = rate * rate_over_speed(r[0], r[1]) / rate_over_speed(r[2], r[3]);
        const double inner_end = across(at_post, std::pow(r[0] / r[1], 2));
        constexpr double margin = 1.5;
        return {std::min(outer_end, inner_end / margin), std::max(rate, at_post * margin)};
    }
    return {rate, rate};
}

/// d ln stress / d ln rate.
double slope_at(const laws::flow::AnyFlowLaw& law, double rate) {
    return std::visit([rate](const auto& it) { return static_cast<double>(it.log_slope(rate)); },
                      law);
}

constexpr long fewest_iterations = 10;
/// Of cells that are not all orthogonal: what that adds is taken from the iteration before, which
/// leaves less than half of its error (measured around cones of 120 degrees).
constexpr long enough_for_skew_cells = 20;

/// Where a part of the fluid yields or comes near it, the torque was within 1e-3 of what it came to
/// after 140 iterations in a gap and 230 around a bob, within 1e-4 after 500, 1e-5 after 900
/// (n = 0.5, tau_0 / (K rate^n) from 0.3 to 30, 20 to 160 cells across; at 100 the two torques
/// balance to 0.24 % after 180): as many as leave a few hundredths of the accuracy. What is left is
/// told from how the row still moves.
long enough_with_plug(double accuracy) {
    constexpr double at_one_percent = 500.0;
    constexpr double for_a_decade = 400.0;
    const double count = at_one_percent + for_a_decade * (-2.0 - std::log10(accuracy));
    return std::clamp(std::lround(count), 400L, 3000L);
}

/// Iterations of a row whose rotor turns at `speed`.
long iterations_at(const Scene& scene, double speed, long fewest) {
    if (is_newtonian(scene) || speed == 0.0)
        return fewest;
    const laws::flow::AnyFlowLaw& law = scene.fluid.law;
    const long most = enough_with_plug(scene.solver.accuracy);
    // Around ends the fluid comes to rest.
    if (has_ends(scene) && laws::flow::yield_stress(law) > 0.0)
        return most;
    const radial::SteadyInstrumentFlow flow =
        radial::steady_instrument_flow(scene.instrument, law, speed);
    RateSpan span = span_of(scene.instrument, law, flow.rotor_wall_rate);
    constexpr double part_at_rest = 1e-6;
    if (has_ends(scene))
        span.least *= part_at_rest;
    if (flow.partly_sheared || span.least <= 0.0)
        return most;
    double left = 0.0; // of an error, after an iteration
    constexpr int parts = 8;
    for (int part = 0; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        const double rate = span.least * std::pow(span.largest / span.least, share);
        left = std::max(left, std::abs(1.0 - slope_at(law, rate)));
    }
    const double aim = 1e-4 * std::min(1.0, scene.solver.accuracy);
    constexpr double margin = 1.3;
    const double count = margin * std::log(aim) / std::log(std::clamp(left, 1e-3, 1.0 - 1e-9));
    return std::clamp(std::lround(std::ceil(count)), fewest, most);
}

/// A viscosity is found by repeated substitution, which leaves |1 - s| of an error each time: as
/// often as brings it to 2 %. Beside a plug that gains little, and shorter steps as much.
int viscosity_corrections(const laws::flow::AnyFlowLaw& law) {
    constexpr double aim = 0.02;
    constexpr int with_plug = 6;
    const double left = std::abs(1.0 - flow_index_of(law));
    if (laws::flow::yield_stress(law) > 0.0 || left >= 1.0)
        return with_plug;
    const double count = std::ceil(std::log(aim) / std::log(std::max(left, 1e-3)));
    return std::clamp(static_cast<int>(count), 3, 20);
}

/// Residual of the velocity with which a steady row ends. What a row still moves when it ends was
/// measured around the ISO bob in water: 9 times the residual of the velocity along the axis at
/// omega R^2 / nu of 147, 42 times at 1466; from a flow at rest, in the end, it falls by e in
/// 14.5 sqrt(omega R^2 / nu) iterations, whatever the mesh and the relaxation. The row ends where
/// that is unsettled_part.
double residual_of_rows(const Scene& scene, const Plan& plan) {
    double reynolds = 0.0;
    for (const RowForecast& row : plan.rows)
        reynolds = std::max(reynolds, row.end_reynolds);
    // Nothing tells that of other scenes, nor how a viscosity that depends on the rate delays it.
    const bool is_known = reynolds > 0.0 && is_newtonian(scene) && !scene.profile;
    const double moves = is_known ? std::max(4.0, 1.1 * std::sqrt(reynolds)) : 5000.0;
    return std::max(1e-10, unsettled_part(scene.solver.accuracy) / moves);
}

} // namespace

double least_rate(const Scene& scene, double speed) {
    const radial::SteadyInstrumentFlow flow =
        radial::steady_instrument_flow(scene.instrument, scene.fluid.law, speed);
    if (flow.partly_sheared)
        return 0.0;
    return span_of(scene.instrument, scene.fluid.law, flow.rotor_wall_rate).least;
}

double flow_index_of(const laws::flow::AnyFlowLaw& law) {
    return std::visit(
        [](const auto& it) {
            if constexpr (requires { it.flow_index; })
                return it.flow_index;
            else
                return 1.0;
        },
        law);
}

void choose_corrections(const Scene& scene, const Plan& plan, FoamPlan& foam) {
    const bool is_rate_dependent = !is_newtonian(scene);
    if (foam.steady) {
        // A march in time with a step of about relaxation / (1 - relaxation) cells' diffusion
        // times: where nothing but the swirl is to be found it may be long.
        foam.outer_corrections = 1;
        foam.residual = residual_of_rows(scene, plan);
        if (foam.swirl_alone) {
            foam.relaxation = 0.99;
            return;
        }
        foam.relaxation = is_rate_dependent ? 0.9 : 0.95;
        // Without, SIMPLEC diverges around a bob in water (omega R^2 / nu of 1500).
        foam.pressure_relaxation = 0.5;
        return;
    }
    if (foam.swirl_alone) {
        // A wedge takes the turn of the velocity from side to side from the correction before, and
        // the second has it to 1e-5 (measured).
        foam.outer_corrections = is_rate_dependent ? viscosity_corrections(scene.fluid.law)
                                 : foam.skew_cells ? 3
                                 : is_box(scene)   ? 1
                                                   : 2;
        return;
    }
    // SIMPLEC's pressure equation has its coefficients from what a row of the matrix has left over,
    // which far beyond the cells' diffusion times is next to nothing: without relaxation the
    // corrections diverge (oil around a DIN bob). Vortices grow only where inertia outweighs that;
    // what relaxation leaves behind would cost them 1 % of the torque (10 cells across).
    if (foam.vortices && !is_rate_dependent) {
        foam.outer_corrections = 2;
        return;
    }
    // Of a thick fluid around a bob off its axis they diverge with the pressure unrelaxed, too, and
    // with more than one pressure correction to a velocity. What seven leave puts the torque 2e-5
    // off on the second level (water and 10 Pa s, bobs 0.3 and 0.7 of the gap off); five left 2e-4,
    // and with 0.9 and 0.5 a thousandth.
    foam.relaxation = 0.95;
    foam.pressure_relaxation = 0.7;
    foam.pressure_corrections = 1;
    foam.outer_corrections = 7;
}

std::vector<long> row_ends(const Scene& scene, const FoamPlan& foam) {
    std::vector<long> ends;
    long end = 0;
    for (const double speed : foam.speeds.speeds) {
        end += iterations_at(scene, speed,
                             foam.skew_cells ? enough_for_skew_cells : fewest_iterations);
        ends.push_back(end);
    }
    return ends;
}

} // namespace searle::solvers::openfoam
