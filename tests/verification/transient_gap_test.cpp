#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/gap_run.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "verification/newtonian_start_up.hpp"
#include "verification/regularised_finite_volumes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers::radial {
namespace {

using namespace laws::flow;

const GapShape water_gap{.planar = false, .inner = 0.014, .outer = 0.015, .density = 998.2};
const Newtonian water{1.0016e-3};

rheometry::SpeedHistory ramp(double speed, double duration, std::vector<double> rows) {
    return {.pieces = {{0.0, duration, 0.0, speed}}, .row_times = std::move(rows)};
}

std::vector<double> wall_flux(const GapShape& shape, const AnyFlowLaw& law,
                              const rheometry::SpeedHistory& history,
                              const GapResolution& resolution) {
    std::vector<double> flux;
    const GapRun run = run_gap(shape, law, history, resolution,
                               [&](std::size_t, const GapRow& row) { flux.push_back(row.flux); });
    EXPECT_TRUE(run.finished);
    // What the walls delivered is in the fluid: the momentum balance holds to rounding.
    EXPECT_LT(run.momentum_defect, 1e-12);
    return flux;
}

double steady_newtonian_flux(const GapShape& shape, double viscosity, double speed) {
    const double a = shape.inner;
    const double b = shape.outer;
    return shape.planar ? viscosity * speed / shape.width()
                        : 2.0 * viscosity * speed * a * a * b * b / ((b - a) * (b + a));
}

// The seven-digit values of eta_app/eta for the 35 s ramp 0 to 100 1/s (bob wall), recomputed
// independently and recorded with the physics of this program.
TEST(TransientGap, water_ramp_matches_the_checked_values) {
    const double delta = 15.0 / 14.0;
    const double speed = 100.0 * (delta * delta - 1.0) / (2.0 * delta * delta);
    const std::vector<double> times{0.1, 0.5, 1.0, 5.0, 10.0, 35.0};
    const std::vector<double> expected{3.310969, 1.596579, 1.299566, 1.059915, 1.029957, 1.008559};
    const auto flux = wall_flux(water_gap, water, ramp(speed, 35.0, times),
                                {.elements = 48, .layer = 3e-4, .step_tolerance = 1e-8});
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double steady =
            steady_newtonian_flux(water_gap, water.viscosity, speed * times[k] / 35.0);
        EXPECT_NEAR(-flux[k] / steady, expected[k], 6e-7) << times[k];
    }
}

// The series itself against those values, so that it may judge the solver elsewhere.
TEST(TransientGap, exact_series_matches_the_checked_values) {
    const auto exact =
        verification::NewtonianStartUp::annulus(0.014, 0.015, water.viscosity / 998.2, 200);
    EXPECT_NEAR(exact.lag(), 0.2996, 5e-5);
    const double times[] = {0.1, 0.5, 1.0, 5.0, 10.0, 35.0};
    const double expected[] = {3.310969, 1.596579, 1.299566, 1.059915, 1.029957, 1.008559};
    for (int k = 0; k < 6; ++k) {
        EXPECT_NEAR(exact.viscosity_ratio(times[k]), expected[k], 5.1e-7) << times[k];
    }
}

TEST(TransientGap, wall_flux_error_falls_with_fourth_order_in_the_element_size) {
    const std::vector<double> times{0.3, 1.0, 3.0};
    const auto exact =
        verification::NewtonianStartUp::annulus(0.014, 0.015, water.viscosity / 998.2, 400);
    std::vector<double> error;
    for (const int elements : {4, 8, 16}) {
        const auto flux = wall_flux(water_gap, water, ramp(1.0, 5.0, times),
                                    {.elements = elements, .layer = 1e-3, .step_tolerance = 1e-10});
        double worst = 0.0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double truth = steady_newtonian_flux(water_gap, water.viscosity, times[k] / 5.0) *
                                 exact.viscosity_ratio(times[k]);
            worst = std::max(worst, std::abs(-flux[k] / truth - 1.0));
        }
        error.push_back(worst);
    }
    EXPECT_GT(std::log2(error[0] / error[1]), 3.7) << error[0] << ' ' << error[1];
    EXPECT_GT(std::log2(error[1] / error[2]), 3.7) << error[1] << ' ' << error[2];
    EXPECT_LT(error[2], 1e-6);
}

TEST(TransientGap, error_follows_the_step_tolerance) {
    const std::vector<double> times{1.0, 5.0};
    const auto exact =
        verification::NewtonianStartUp::annulus(0.014, 0.015, water.viscosity / 998.2, 400);
    double before = INFINITY;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const auto flux = wall_flux(water_gap, water, ramp(1.0, 5.0, times),
                                    {.elements = 96, .layer = 1e-3, .step_tolerance = tolerance});
        double worst = 0.0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double truth = steady_newtonian_flux(water_gap, water.viscosity, times[k] / 5.0) *
                                 exact.viscosity_ratio(times[k]);
            worst = std::max(worst, std::abs(-flux[k] / truth - 1.0));
        }
        EXPECT_LT(worst, 3.0 * tolerance);
        EXPECT_LT(worst, 0.3 * before);
        before = worst;
    }
}

// In a plane gap a Bingham fluid that is sheared everywhere in one direction obeys the Newtonian
// equation, with tau0 added to the stress: d(tau0 + mu |v'|)/dy = mu v''. A moving wall that only
// speeds up shears all of it at once (momentum has no front), so the closed form holds from the
// start.
TEST(TransientGap, bingham_ramp_in_a_box_is_the_newtonian_one_plus_the_yield_stress) {
    const GapShape box{.planar = true, .inner = 0.0, .outer = 1e-3, .density = 1000.0};
    const double viscosity = 2e-3;
    const double yield = 0.7;
    const std::vector<double> times{0.02, 0.1, 0.4, 2.0};
    const auto exact = verification::NewtonianStartUp::plane(1e-3, viscosity / 1000.0, 400);
    std::vector<double> error;
    for (const int elements : {6, 12, 24}) {
        const auto flux = wall_flux(box, Bingham{yield, viscosity}, ramp(0.2, 2.0, times),
                                    {.elements = elements, .layer = 2e-4, .step_tolerance = 1e-8});
        double worst = 0.0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double truth =
                yield + viscosity * 0.1 * times[k] / 1e-3 * exact.viscosity_ratio(times[k]);
            worst = std::max(worst, std::abs(-flux[k] / truth - 1.0));
        }
        error.push_back(worst);
    }
    EXPECT_GT(std::log2(error[0] / error[1]), 3.0) << error[0] << ' ' << error[1];
    EXPECT_GT(std::log2(error[1] / error[2]), 3.0) << error[1] << ' ' << error[2];
    EXPECT_LT(error[2], 2e-6);
}

TEST(TransientGap, slow_ramps_tend_to_the_steady_flow_for_every_law) {
    const GapShape gap{.planar = false, .inner = 0.010, .outer = 0.013, .density = 1000.0};
    const std::vector<double> times{5e4, 1e5};
    for (const AnyFlowLaw& law :
         {AnyFlowLaw{Bingham{2.0, 0.1}}, AnyFlowLaw{PowerLaw{0.5, 0.4}},
          AnyFlowLaw{HerschelBulkley{5.0, 0.5, 0.5}}, AnyFlowLaw{Casson{2.0, 0.1}},
          AnyFlowLaw{CarreauYasuda{5.0, 0.01, 1.0, 0.4, 2.0}},
          AnyFlowLaw{Cross{5.0, 0.01, 1.0, 0.4}}}) {
        double before = INFINITY;
        for (const int elements : {4, 8, 16}) {
            const auto flux =
                wall_flux(gap, law, ramp(5.0, 1e5, times),
                          {.elements = elements, .layer = 3e-3, .step_tolerance = 1e-7});
            double worst = 0.0;
            for (std::size_t k = 0; k < times.size(); ++k) {
                // Inertia: density width^2 / viscosity = 0.1 s against 5e4 s.
                const double stress =
                    steady_gap_flow({gap.inner, gap.outer}, law, 5.0 * times[k] / 1e5)
                        .inner_wall_stress;
                worst =
                    std::max(worst, std::abs(-flux[k] / (gap.inner * gap.inner) / stress - 1.0));
            }
            EXPECT_LT(worst, std::max(0.5 * before, 3e-6)) << name_of(law) << ' ' << elements;
            before = worst;
        }
        EXPECT_LT(before, 1e-5) << name_of(law);
    }
}

TEST(TransientGap, outer_and_inner_rotor_carry_opposite_torques_that_agree_in_a_narrow_gap) {
    const GapShape inner{.planar = false, .inner = 0.02, .outer = 0.02002, .density = 1000.0};
    GapShape outer = inner;
    outer.outer_wall_moves = true;
    const auto history = ramp(1.0, 1.0, {1.0});
    const GapResolution resolution{.elements = 12, .layer = 1e-4, .step_tolerance = 1e-8};
    const double on_inner = wall_flux(inner, water, history, resolution)[0];
    const double on_outer = wall_flux(outer, water, history, resolution)[0];
    EXPECT_LT(on_inner, 0.0);
    EXPECT_GT(on_outer, 0.0);
    EXPECT_NEAR(-on_outer / on_inner, 1.0, 1e-5);
}

// The rotor of a double gap's inner annulus: the outer wall turns. After the start's transient the
// ramp obeys 1 + T/t with T in closed form (docs/radial.md, eq. 7, with the walls' roles
// exchanged).
TEST(TransientGap, ramp_of_an_outer_rotor_matches_the_closed_form) {
    for (const double outer : {0.015, 0.030}) {
        const GapShape gap{.planar = false,
                           .inner = 0.014,
                           .outer = outer,
                           .outer_wall_moves = true,
                           .density = 998.2};
        const double nu = water.viscosity / gap.density;
        const double decay = gap.width() * gap.width() / (nu * 9.0);
        const double time = 40.0 * decay;
        const double lag = verification::annulus_lag(gap.inner, gap.outer, nu, true);
        EXPECT_GT(std::abs(lag), 0.001 * time) << "the inertia must be there to be seen";
        const auto flux =
            wall_flux(gap, water, ramp(1.0, time, {time}),
                      {.elements = 40, .layer = 0.2 * gap.width(), .step_tolerance = 1e-8});
        const double exact = steady_newtonian_flux(gap, water.viscosity, 1.0) * (1.0 + lag / time);
        EXPECT_NEAR(flux[0] / exact, 1.0, 1e-7) << outer;
    }
}

TEST(TransientGap, lag_of_a_narrow_annulus_is_the_plane_gap_s_at_either_wall) {
    EXPECT_NEAR(verification::annulus_lag(1.0, 1.0001, 1.0) / (1e-8 / 3.0), 1.0, 1e-3);
    EXPECT_NEAR(verification::annulus_lag(1.0, 1.0001, 1.0, true) / (1e-8 / 3.0), 1.0, 1e-3);
}

TEST(TransientGap, double_gap_s_torque_is_the_sum_of_its_annuli) {
    const auto history = ramp(2.0, 3.0, {0.5, 3.0});
    const std::vector<RotorGap> gaps =
        rotor_gaps(geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.055}, 998.2);
    const auto both = solve_levels(gaps, water, history, 1e-6, {});
    const auto inner = solve_levels({&gaps[0], 1}, water, history, 1e-6, {});
    const auto outer = solve_levels({&gaps[1], 1}, water, history, 1e-6, {});
    ASSERT_TRUE(both.reached);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_GT(inner.torque[k], 0.0);
        EXPECT_GT(outer.torque[k], 0.0);
        EXPECT_NEAR(both.torque[k] / (inner.torque[k] + outer.torque[k]), 1.0, 2e-6);
    }
}

// An abrupt stop leaves the stress inside the stopped fluid open: the bar has to say so, and the
// rows must not keep the levels from ending.
TEST(TransientGap, rows_at_rest_after_a_jump_to_zero_cover_what_the_law_allows) {
    rheometry::SpeedHistory history{.pieces = {{0.0, 1.0, 10.0, 10.0}, {1.0, 2.0, 0.0, 0.0}},
                                    .row_times = {0.5, 1.0, 1.5, 2.0},
                                    .initial_speed = 10.0};
    const std::vector<RotorGap> gap{
        {{.planar = false, .inner = 0.014, .outer = 0.016, .density = 1000.0}, -1.0}};
    for (const AnyFlowLaw& law :
         {AnyFlowLaw{HerschelBulkley{5.0, 0.5, 0.5}}, AnyFlowLaw{Bingham{5.0, 0.05}}}) {
        const double yield = 5.0 * 0.014 * 0.014;
        const auto coarse = solve_levels(gap, law, history, 1e-2, {});
        const auto fine = solve_levels(gap, law, history, 1e-3, {});
        EXPECT_TRUE(coarse.reached && fine.reached) << name_of(law);
        EXPECT_EQ(fine.rests, (std::vector<bool>{false, false, true, true})) << name_of(law);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_LE(std::abs(fine.torque[k] - coarse.torque[k]), coarse.error[k] + fine.error[k]);
        }
        for (std::size_t k = 2; k < 4; ++k) {
            EXPECT_LE(fine.torque[k] - fine.error[k], -yield * (1.0 - 1e-12));
            EXPECT_GE(fine.torque[k] + fine.error[k], yield * (1.0 - 1e-12));
        }
    }
}

TEST(TransientGap, a_tiny_start_before_a_fast_ramp_does_not_spoil_its_rows) {
    rheometry::SpeedHistory history{.pieces = {{0.0, 10.0, 0.0, 1e-6}, {10.0, 20.0, 1e-6, 1.0}},
                                    .row_times = {5.0, 10.0, 15.0, 20.0}};
    const auto found =
        solve_levels(std::vector<RotorGap>{{water_gap, -1.0}}, water, history, 1e-3, {});
    EXPECT_TRUE(found.reached);
    EXPECT_LE(found.levels, 4);
}

TEST(TransientGap, start_from_steady_flow_shows_no_transient_at_constant_speed) {
    for (const AnyFlowLaw& law : {AnyFlowLaw{water}, AnyFlowLaw{HerschelBulkley{5.0, 0.5, 0.5}},
                                  AnyFlowLaw{Cross{5.0, 0.01, 1.0, 0.4}}}) {
        rheometry::SpeedHistory history{
            .pieces = {{0.0, 1.0, 3.0, 3.0}}, .row_times = {0.01, 1.0}, .initial_speed = 3.0};
        const auto flux = wall_flux(water_gap, law, history,
                                    {.elements = 16, .layer = 1e-3, .step_tolerance = 1e-8});
        EXPECT_NEAR(flux[0] / flux[1], 1.0, 1e-9) << name_of(law);
    }
}

TEST(TransientGap, a_stopped_yield_stress_fluid_keeps_the_stress_it_stopped_with) {
    rheometry::SpeedHistory history{
        .pieces = {{0.0, 1.0, 0.0, 5.0}, {1.0, 2.0, 5.0, 0.0}, {2.0, 4.0, 0.0, 0.0}},
        .row_times = {1.0, 3.0, 4.0}};
    const GapShape gap{.planar = false, .inner = 0.014, .outer = 0.018, .density = 1000.0};
    const auto flux = wall_flux(gap, Bingham{5.0, 0.05}, history,
                                {.elements = 24, .layer = 1e-3, .step_tolerance = 1e-6});
    // At rest the wall carries the yield stress: the flow stopped because the stress fell to it.
    EXPECT_NEAR(-flux[1] / (0.014 * 0.014), 5.0, 1e-3);
    EXPECT_NEAR(flux[2] / flux[1], 1.0, 1e-6);
}

} // namespace
} // namespace searle::solvers::radial
