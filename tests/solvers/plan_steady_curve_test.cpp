#include "solvers/plan_steady_curve.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace searle::solvers {
namespace {

const geometry::Instrument single_gap = geometry::ConcentricCylinders{0.014, 0.0155, 0.042};
const geometry::Instrument double_gap =
    geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.055};
const geometry::Instrument box = geometry::Box{0.001, 0.02, 0.03};
const geometry::Instrument din_bob = geometry::DinBob{0.014, 0.0152};

std::vector<Fluid> fluids() {
    return {{laws::flow::Newtonian{0.01}, 1000.0},
            {laws::flow::Bingham{5.0, 0.2}, 1100.0},
            {laws::flow::PowerLaw{1.0, 0.3}, 900.0},
            {laws::flow::PowerLaw{0.01, 1.6}, 900.0},
            {laws::flow::HerschelBulkley{5.0, 0.5, 0.5}, 1200.0},
            {laws::flow::Casson{2.0, 0.05}, 1050.0},
            {laws::flow::CarreauYasuda{1.0, 0.001, 0.5, 0.4, 2.0}, 1000.0},
            {laws::flow::Cross{1.0, 0.001, 0.5, 0.3}, 1000.0}};
}

// Origin: radial::steady_instrument_flow, the solver that the results come from.
TEST(SteadyCurve, few_speeds_are_solved_exactly) {
    for (const geometry::Instrument& instrument : {single_gap, double_gap, box, din_bob}) {
        for (const Fluid& fluid : fluids()) {
            SteadyCurve curve(instrument, fluid, std::vector{0.01, -3.0, 50.0});
            for (const double speed : {0.01, -3.0, 50.0}) {
                const radial::SteadyInstrumentFlow exact =
                    radial::steady_instrument_flow(instrument, fluid.law, speed);
                const SteadyState& state = curve.at(speed);
                EXPECT_NEAR(state.torque / std::abs(exact.torque), 1.0, 1e-12);
                EXPECT_NEAR(state.gaps[curve.gaps().size() - 1].inner_rate / exact.rotor_wall_rate,
                            1.0, 1e-12);
            }
        }
    }
}

TEST(SteadyCurve, many_speeds_are_interpolated_to_a_hundred_thousandth) {
    std::vector<double> speeds;
    for (int k = 1; k <= 3000; ++k) {
        speeds.push_back(0.02 * k);
    }
    for (const geometry::Instrument& instrument : {single_gap, double_gap, box}) {
        for (const Fluid& fluid : fluids()) {
            SteadyCurve curve(instrument, fluid, speeds);
            for (const double speed : {0.02, 0.0213, 0.731, 5.02, 31.7, 60.0}) {
                const radial::SteadyInstrumentFlow exact =
                    radial::steady_instrument_flow(instrument, fluid.law, speed);
                EXPECT_NEAR(curve.at(speed).torque / exact.torque, 1.0, 1e-5)
                    << laws::flow::name_of(fluid.law) << " at " << speed;
            }
        }
    }
}

// Between partly and wholly sheared the flow curve has a kink in its curvature.
TEST(SteadyCurve, interpolation_keeps_four_digits_where_the_yield_surface_reaches_the_wall) {
    std::vector<double> speeds;
    for (int k = 1; k <= 3000; ++k) {
        speeds.push_back(0.001 * k);
    }
    const Fluid fluid{laws::flow::Bingham{5.0, 0.2}, 1100.0};
    SteadyCurve curve(single_gap, fluid, speeds);
    int partly_sheared = 0;
    for (const double speed : speeds) {
        const radial::SteadyInstrumentFlow exact =
            radial::steady_instrument_flow(single_gap, fluid.law, speed);
        partly_sheared += exact.partly_sheared ? 1 : 0;
        EXPECT_NEAR(curve.at(speed).torque / exact.torque, 1.0, 1e-4);
    }
    EXPECT_GT(partly_sheared, 0);
    EXPECT_LT(partly_sheared, 3000);
}

TEST(SteadyCurve, rest_needs_no_flow) {
    SteadyCurve curve(single_gap, fluids()[4], std::vector{0.0, 0.0});
    EXPECT_TRUE(curve.at_rest_only());
}

// A series at a single speed has no range to interpolate over.
TEST(SteadyCurve, many_equal_speeds_are_one_speed) {
    const std::vector<double> speeds(2000, 4.0);
    SteadyCurve curve(single_gap, fluids()[4], speeds);
    const double exact = radial::steady_instrument_flow(single_gap, fluids()[4].law, 4.0).torque;
    EXPECT_NEAR(curve.at(-4.0).torque / exact, 1.0, 1e-12);
}

} // namespace
} // namespace searle::solvers
