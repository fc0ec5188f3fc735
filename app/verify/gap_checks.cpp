#include "app/verify/check.hpp"
#include "laws/gap/eccentric_cylinders.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/gap_run.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "verification/newtonian_start_up.hpp"
#include "verification/regularised_finite_volumes.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace searle::app::verify {
namespace {

using namespace laws::flow;
using namespace solvers::radial;

constexpr double pi = std::numbers::pi;
const GapShape water_gap{.planar = false, .inner = 0.014, .outer = 0.015, .density = 998.2};
const Newtonian water{1.0016e-3};

Found herschel_bulkley_values() {
    const auto narrow = steady_gap_flow({0.014, 0.015}, HerschelBulkley{5.0, 0.5, 0.5}, 10.0);
    const auto wide = steady_gap_flow({0.010, 0.020}, HerschelBulkley{20.0, 2.0, 0.4}, 0.05);
    return {std::max({relative(narrow.inner_wall_stress, 11.7802557634299),
                      relative(narrow.inner_wall_rate, 183.887472870097),
                      relative(narrow.torque_per_length, 0.0145074358658097),
                      relative(wide.inner_wall_stress, 22.9504355400752),
                      relative(wide.inner_wall_rate, 2.64326276260158),
                      relative(wide.yield_radius, 10.7122442886809e-3)})};
}

Found bingham_closed_form() {
    // omega = (tau / 2 mu)(1 - 1/delta^2) - (tau0 / mu) ln(delta)
    constexpr double delta = 1.2;
    constexpr double omega = 40.0;
    const Bingham law{3.0, 0.2};
    const double exact = 2.0 * law.plastic_viscosity *
                         (omega + law.yield_stress / law.plastic_viscosity * std::log(delta)) /
                         (1.0 - 1.0 / (delta * delta));
    return {relative(steady_gap_flow({0.01, 0.012}, law, omega).inner_wall_stress, exact)};
}

Found power_law_closed_form() {
    double worst = 0.0;
    for (const double n : {0.1, 0.3, 1.0, 1.7})
        for (const double delta : {1.001, 1.5, 20.0}) {
            const auto flow = steady_gap_flow({0.01, 0.01 * delta}, PowerLaw{2.0, n}, 0.3);
            const double exact = 2.0 * 0.3 / (n * -std::expm1(-2.0 / n * std::log(delta)));
            worst = std::max(worst, relative(flow.inner_wall_rate, exact));
        }
    return {worst};
}

Found double_gap_closed_form() {
    const geometry::DoubleGap gap{.radii = {0.02, 0.02038, 0.02196, 0.02238}, .height = 0.055};
    const auto [r1, r2, r3, r4] = gap.radii;
    const double exact =
        4.0 * pi * 1e-3 * 5.0 * gap.height *
        (r1 * r1 * r2 * r2 / (r2 * r2 - r1 * r1) + r3 * r3 * r4 * r4 / (r4 * r4 - r3 * r3));
    return {relative(steady_instrument_flow(gap, Newtonian{1e-3}, 5.0).torque, exact)};
}

/// Largest error of torque and force against Sommerfeld's bearing, r = 1.
double off_sommerfeld(double gap) {
    double worst = 0.0;
    for (const double part : {0.1, 0.5, 0.9}) {
        const laws::gap::EccentricCylinders it{1.0, 1.0 + gap, part * gap};
        const double bearing = (2.0 + part * part) * std::sqrt(1.0 - part * part);
        worst = std::max(
            {worst,
             relative(it.torque_factor(), 4.0 * pi / gap * (1.0 + 2.0 * part * part) / bearing),
             relative(it.force_factor(), 12.0 * pi * part / (gap * gap * bearing))});
    }
    return worst;
}

Found eccentric_sommerfeld() {
    return {off_sommerfeld(2.5e-4), order_of(off_sommerfeld(5e-4), off_sommerfeld(2.5e-4))};
}

Found box_closed_form() {
    const geometry::Box box{.gap = 1e-3, .length = 0.1, .width = 0.05};
    const double force = HerschelBulkley{5.0, 0.5, 0.5}.stress(0.02 / 1e-3) * 0.1 * 0.05;
    return {
        relative(steady_instrument_flow(box, HerschelBulkley{5.0, 0.5, 0.5}, 0.02).torque, force)};
}

rheometry::SpeedHistory ramp(double speed, double duration, std::vector<double> rows) {
    return {.pieces = {{0.0, duration, 0.0, speed}}, .row_times = std::move(rows)};
}

std::vector<double> wall_flux(const GapShape& shape, const AnyFlowLaw& law,
                              const rheometry::SpeedHistory& history,
                              const GapResolution& resolution) {
    std::vector<double> flux;
    const GapRun run = run_gap(shape, law, history, resolution,
                               [&](std::size_t, const GapRow& row) { flux.push_back(-row.flux); });
    if (!run.finished)
        throw std::runtime_error("the run did not get to its end");
    return flux;
}

double steady_flux(double speed) {
    const double a = water_gap.inner;
    const double b = water_gap.outer;
    return 2.0 * water.viscosity * speed * a * a * b * b / ((b - a) * (b + a));
}

Found water_ramp_values() {
    const double delta = 15.0 / 14.0;
    const double speed = 100.0 * (delta * delta - 1.0) / (2.0 * delta * delta);
    const std::vector<double> times{0.1, 0.5, 1.0, 5.0, 10.0, 35.0};
    const std::vector<double> expected{3.310969, 1.596579, 1.299566, 1.059915, 1.029957, 1.008559};
    const auto flux = wall_flux(water_gap, water, ramp(speed, 35.0, times),
                                {.elements = 48, .layer = 3e-4, .step_tolerance = 1e-8});
    double worst = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k)
        worst =
            std::max(worst, std::abs(flux[k] / steady_flux(speed * times[k] / 35.0) - expected[k]));
    return {worst};
}

Found water_ramp_order() {
    const std::vector<double> times{0.3, 1.0, 3.0};
    const auto exact =
        verification::NewtonianStartUp::annulus(0.014, 0.015, water.viscosity / 998.2, 400);
    std::vector<double> errors;
    for (const int elements : {4, 8, 16}) {
        const auto flux = wall_flux(water_gap, water, ramp(1.0, 5.0, times),
                                    {.elements = elements, .layer = 1e-3, .step_tolerance = 1e-10});
        double worst = 0.0;
        for (std::size_t k = 0; k < times.size(); ++k)
            worst = std::max(worst, relative(flux[k], steady_flux(times[k] / 5.0) *
                                                          exact.viscosity_ratio(times[k])));
        errors.push_back(worst);
    }
    return {errors[2], order_of(errors[1], errors[2])};
}

Found slurry_ramp_against_finite_volumes() {
    const HerschelBulkley law{2.0, 0.2, 0.5};
    rheometry::SpeedHistory history = ramp(30.0, 0.05, {0.0125, 0.025, 0.0375});
    const std::vector<RotorGap> gap{
        {{.planar = false, .inner = 0.014, .outer = 0.016, .density = 1000.0}, -1.0}};
    const TransientTorque solved = solve_levels(gap, law, history, 1e-5, {});
    const verification::FiniteVolumeScene scene{0.014, 0.016, 1000.0, law, [&](double time) {
                                                    return history.speed_at(std::min(time, 0.05));
                                                }};
    std::vector<double> errors;
    for (const int level : {0, 1, 2}) {
        const int cells = 50 << level;
        const double step = 0.05 / (200 << level);
        const double rounding = 8e-3 * 30.0 * 0.014 / 0.002 * std::pow(0.5, level);
        const auto coarse =
            verification::regularised_wall_stress(scene, history.row_times, cells, step, rounding);
        const auto fine = verification::regularised_wall_stress(scene, history.row_times, cells,
                                                                step / 2, rounding);
        double worst = 0.0;
        for (std::size_t k = 0; k < fine.size(); ++k) {
            const double stress = 2.0 * fine[k] - coarse[k];
            worst = std::max(worst, relative(stress, solved.torque[k] / (0.014 * 0.014)));
        }
        errors.push_back(worst);
    }
    return {errors[2], order_of(errors[1], errors[2])};
}

} // namespace

std::vector<Check> gap_checks() {
    const std::string steady = "tests/verification/steady_gap_test.cpp";
    const std::string transient = "tests/verification/transient_gap_test.cpp";
    return {
        {.name = "gap-herschel-bulkley-values",
         .subject = "steady flow in a gap, Herschel-Bulkley, all and partly sheared",
         .against = "checked values of two scenes to 15 digits: stress, rate, torque, yield radius",
         .tolerance = 2e-13,
         .origin = "the values' last digit, and rounding",
         .file = steady,
         .test = "SteadyGap.herschel_bulkley_matches_the_checked_values",
         .run = herschel_bulkley_values},
        {.name = "gap-bingham-closed-form",
         .subject = "steady flow in a gap, Bingham sheared throughout",
         .against = "Reiner and Riwlin 1927",
         .tolerance = 1e-12,
         .origin = "rounding",
         .file = steady,
         .test = "SteadyGap.bingham_sheared_throughout_matches_reiner_and_riwlin",
         .run = bingham_closed_form},
        {.name = "gap-power-law-closed-form",
         .subject = "steady flow in gaps from 0.1 % to 20 radii, power law",
         .against = "rate = 2 omega / (n (1 - delta^(-2/n)))",
         .tolerance = 1e-10,
         .origin = "what the solver states",
         .file = steady,
         .test = "SteadyGap.power_law_rate_matches_the_closed_form",
         .run = power_law_closed_form},
        {.name = "double-gap-closed-form",
         .subject = "steady torque of a double gap, Newtonian",
         .against = "4 pi eta omega L times the sum over both annuli",
         .tolerance = 1e-10,
         .origin = "what the solver states",
         .file = steady,
         .test = "SteadyInstrument.double_gap_is_the_sum_of_both_annuli",
         .run = double_gap_closed_form},
        {.name = "box-closed-form",
         .subject = "steady force on the box's wall, Herschel-Bulkley",
         .against = "the law's stress at U/h times the area",
         .tolerance = 1e-13,
         .origin = "rounding",
         .file = steady,
         .test = "SteadyInstrument.box_force_is_stress_times_area_and_odd_in_the_speed",
         .run = box_closed_form},
        {.name = "eccentric-sommerfeld",
         .subject = "creeping flow around an eccentric bob, closed form: torque and side force",
         .against = "Sommerfeld's bearing 1904, gaps of 1/1000 to 1/4000 of the radius",
         .tolerance = 1e-3,
         .origin = "the bearing's neglect of curvature, first order in the gap",
         .least_order = 0.95,
         .file = "tests/laws/eccentric_cylinders_test.cpp",
         .test = "EccentricCylinders.a_narrow_gap_tends_to_sommerfelds_bearing_in_first_order_of_"
                 "the_gap",
         .run = eccentric_sommerfeld},
        {.name = "ramp-water-values",
         .subject = "flow in time in a gap: water from rest, 0 to 100 1/s in 35 s",
         .against = "checked eta_app/eta at 0.1, 0.5, 1, 5, 10 and 35 s to seven digits",
         .tolerance = 6e-7,
         .origin = "half the values' last digit, and the step's tolerance",
         .file = transient,
         .test = "TransientGap.water_ramp_matches_the_checked_values",
         .run = water_ramp_values},
        {.name = "ramp-water-order",
         .subject = "flow in time in a gap: 4, 8 and 16 elements",
         .against = "the exact series of the start-up (400 modes)",
         .tolerance = 1e-6,
         .origin = "fourth order from 1e-4 at 4 elements",
         .least_order = 3.7,
         .file = transient,
         .test = "TransientGap.wall_flux_error_falls_with_fourth_order_in_the_element_size",
         .run = water_ramp_order},
        {.name = "ramp-slurry-finite-volumes",
         .subject = "flow in time in a gap: Herschel-Bulkley ramp with a moving plug",
         .against = "regularised finite volumes with implicit Euler, 50, 100 and 200 cells",
         .tolerance = 2e-3,
         .origin = "the regularisation of the reference, first order",
         .least_order = 0.6,
         .file = "tests/verification/independent_finite_volumes_test.cpp",
         .test = "IndependentMethod.regularised_finite_volumes_tend_to_the_solver_s_torque",
         .run = slurry_ramp_against_finite_volumes},
    };
}

} // namespace searle::app::verify
