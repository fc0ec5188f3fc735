#include "solvers/axisymmetric/swirl_response.hpp"
#include "solvers/meridional/flow_level.hpp"
#include "solvers/meridional/flow_material.hpp"
#include "solvers/meridional/flow_stepper.hpp"
#include "solvers/meridional/transient_secondary_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers::meridional {
namespace {

namespace flow = laws::flow;

const geometry::DinBob iso_bob{.bob_radius = 1.0, .cup_radius = 1.0847};
constexpr FlowResolution coarse{.degree = 4, .smallest = 0.3, .largest = 1.0, .beside = 8.0};
constexpr auto rotation = static_cast<Eigen::Index>(Component::rotation);

/// Lengths in bob radii, time over 1 / reference speed: omega R^2 / nu = 150, so that the gap's own
/// time (gap^2 / nu) is about 1.
ScaledFluid fluid_of_150() { return {flow::Newtonian{1.0}, 150.0, 1.0, 1.0, 1.0, 1e-5}; }

/// Follows a start from rest with constant acceleration until `start`.
FlowState smooth_start(FlowLevel& level, const FlowMaterial& material, double start) {
    FlowStepper stepper(level.system(), material, rest(level.space()),
                        {.tolerance = 1e-8, .first_step = 1e-4});
    stepper.begin({.start_time = 0.0, .speed = 0.0, .acceleration = 0.3});
    while (stepper.time() < start) {
        EXPECT_TRUE(stepper.step(start));
    }
    return stepper.state();
}

/// ESDIRK4(3)6L[2]SA: error against number of steps, both as the tolerance falls.
TEST(FlowStepper, velocity_has_order_four_in_time) {
    FlowLevel level(iso_bob, coarse);
    const ScaledFluid fluid = fluid_of_150();
    const FlowState start = smooth_start(level, fluid.material(), 1.0);
    struct End {
        FlowState state;
        long steps;
    };
    const auto run = [&](double tolerance) {
        FlowStepper stepper(level.system(), fluid.material(), start,
                            {.tolerance = tolerance, .first_step = 0.02});
        stepper.begin({.start_time = 1.0, .speed = 0.3, .acceleration = 0.3});
        while (stepper.time() < 4.0) {
            EXPECT_TRUE(stepper.step(4.0));
        }
        return End{stepper.state(), stepper.steps()};
    };
    const End exact = run(1e-10);
    std::vector<double> error;
    std::vector<double> steps;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        const End end = run(tolerance);
        error.push_back((end.state.velocity - exact.state.velocity).cwiseAbs().maxCoeff());
        steps.push_back(static_cast<double>(end.steps));
        EXPECT_LT(error.back(), 3.0 * tolerance);
    }
    EXPECT_NEAR(std::log(error[1] / error[2]) / std::log(steps[2] / steps[1]), 4.0, 0.5);
}

/// Between the ends of a step: cubic polynomials, so the rate of change has order three.
TEST(FlowStepper, torque_between_the_ends_of_a_step_has_order_three) {
    FlowLevel level(iso_bob, coarse);
    const ScaledFluid fluid = fluid_of_150();
    const FlowState start = smooth_start(level, fluid.material(), 1.0);
    const auto torque_at = [&](double step, double time, double tolerance) {
        FlowStepper stepper(level.system(), fluid.material(), start,
                            {.tolerance = tolerance, .first_step = step});
        stepper.begin({.start_time = 1.0, .speed = 0.3, .acceleration = 0.3});
        double end = 1.0;
        while (stepper.time() < time) {
            end += step;
            while (stepper.time() < end) {
                EXPECT_TRUE(stepper.step(end));
            }
        }
        return stepper.torque_at(time);
    };
    std::vector<double> error;
    for (const double step : {0.4, 0.2, 0.1}) {
        const double time = 1.0 + 0.3 * step; // no place of symmetry
        const double exact = torque_at(0.3 * step, time, 1e-9);
        error.push_back(std::abs(torque_at(step, time, 1e-3) / exact - 1.0));
    }
    EXPECT_GT(std::log2(error[1] / error[2]), 2.5);
    EXPECT_LT(error[2], 1e-5);
}

/// d/dt of the fluid's angular momentum is the rotor's torque less the cup's, with convection.
TEST(FlowStepper, torques_of_rotor_and_cup_differ_by_what_the_fluid_takes_up) {
    FlowLevel level(iso_bob, {.degree = 4, .smallest = 0.1, .largest = 0.5, .beside = 8.0});
    const ScaledFluid fluid = fluid_of_150();
    const FlowMaterial material = fluid.material();
    constexpr double middle = 1.0;
    constexpr double apart = 0.01;
    FlowStepper stepper(level.system(), material, rest(level.space()),
                        {.tolerance = 1e-5, .first_step = 1e-3});
    stepper.begin({.start_time = 0.0, .speed = 0.0, .acceleration = 0.5});
    std::vector<FlowState> state;
    double rotor = 0.0;
    for (const double time : {middle - apart, middle, middle + apart}) {
        while (stepper.time() < time) {
            ASSERT_TRUE(stepper.step(time));
        }
        state.push_back(stepper.state());
        if (time == middle) {
            rotor = stepper.torque_at(middle);
        }
    }
    const Eigen::MatrixX3d inertia = level.system().inertia(
        (state[2].velocity - state[0].velocity) / (2.0 * apart), material.reynolds);
    const FlowResidual residual = level.system().residual(state[1], material);
    double cup = 0.0;
    for (int node = 0; node < level.space().nodes(); ++node) {
        if ((level.space().boundary(node) & axisymmetric::cup_wall) != 0U) {
            cup += residual.momentum(node, rotation) + inertia(node, rotation);
        }
    }
    const double taken_up = inertia.col(rotation).sum();
    EXPECT_GT(taken_up, 0.3 * rotor);
    EXPECT_NEAR(rotor + cup, taken_up, 2e-4 * rotor);
}

/// A rotor that keeps its speed ends in the steady flow of the same elements.
TEST(FlowStepper, a_long_hold_ends_in_the_steady_flow) {
    FlowLevel level(iso_bob, coarse);
    const ScaledFluid fluid(flow::Newtonian{1.0}, 60.0, 1.0, 1.0, 1.0, 1e-5);
    FlowStepper stepper(level.system(), fluid.material(), rest(level.space()),
                        {.tolerance = 1e-4, .first_step = 1e-3});
    stepper.begin({.start_time = 0.0, .speed = 1.0, .acceleration = 0.0});
    while (stepper.time() < 300.0) {
        ASSERT_TRUE(stepper.step(300.0));
    }
    const double late = stepper.torque_at(stepper.time());
    ASSERT_TRUE(level.solve_creeping(fluid.material(0.0).law, 1e-20));
    ASSERT_TRUE(level.solve_steady(fluid.material(), 1e-10));
    EXPECT_NEAR(late / level.steady_torque(fluid.material()), 1.0, 1e-6);
    EXPECT_LT(stepper.steps(), 200);
}

/// Speeds a thousand times lower than those of the ramp of water 0 -> 100 1/s in 35 s: secondary
/// flow, of the order of the speed squared, vanishes, and the torque over the speed is that of
/// swirl alone: 1.53, 1.117 and 1.010 times the viscosity at 1, 5, 35 s (an independent
/// axisymmetric computation, to the digits given), and that of the swirl solver with its own
/// reduced system.
TEST(TransientSecondaryFlow, slow_ramp_is_the_ramp_of_swirl_alone) {
    const geometry::DinBob bob{0.014, 0.0152};
    const double rate_per_speed = 12.187215;
    const double stress_per_torque = 16243.2702;
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 35.0, 0.0, 0.1 / rate_per_speed}};
    history.row_times = {0.2, 1.0, 5.0, 20.0, 35.0};
    const double viscosity = 1.0016e-3;
    const TransientTorque found =
        transient_secondary_flow(bob, flow::Newtonian{viscosity}, 998.2, history, 2e-3);
    const axisymmetric::TransientSwirl swirl =
        axisymmetric::transient_swirl(bob, viscosity, 998.2, history, 1e-5);
    EXPECT_TRUE(found.reached);
    ASSERT_EQ(found.torque.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_LE(std::abs(found.torque[k] - swirl.torque[k]), found.error[k] + swirl.error[k]);
        EXPECT_LE(found.error[k], 2e-3 * found.torque[k]);
    }
    const double expected[] = {1.53, 1.117, 1.010};
    const double digits[] = {5e-3, 5e-4, 5e-4};
    const std::size_t row[] = {1, 2, 4};
    for (std::size_t k = 0; k < 3; ++k) {
        const double rate = rate_per_speed * history.speed_at(history.row_times[row[k]]);
        EXPECT_NEAR(found.torque[row[k]] * stress_per_torque / (rate * viscosity), expected[k],
                    digits[k] + found.error[row[k]] / found.torque[row[k]]);
    }
}

/// A jump up, a jump down and a start from a speed that is not zero, as slow as above.
TEST(TransientSecondaryFlow, slow_jumps_are_those_of_swirl_alone) {
    const geometry::DinBob bob{0.014, 0.0152};
    rheometry::SpeedHistory history;
    history.initial_speed = 5e-3;
    history.pieces = {{0.0, 1.0, 1e-2, 1e-2}, {1.0, 2.0, 4e-3, 1e-2}};
    history.row_times = {0.05, 0.3, 1.0, 1.05, 2.0};
    const double viscosity = 1.0016e-3;
    const TransientTorque found =
        transient_secondary_flow(bob, flow::Newtonian{viscosity}, 998.2, history, 1e-2);
    const axisymmetric::TransientSwirl swirl =
        axisymmetric::transient_swirl(bob, viscosity, 998.2, history, 1e-5);
    EXPECT_TRUE(found.reached);
    ASSERT_EQ(found.torque.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_LE(std::abs(found.torque[k] - swirl.torque[k]), found.error[k] + swirl.error[k])
            << k;
    }
}

} // namespace
} // namespace searle::solvers::meridional
