#include "solvers/axisymmetric/swirl_history.hpp"

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/swirl_response.hpp"
#include "solvers/axisymmetric/swirl_stepper.hpp"
#include "solvers/radial/rotor_gaps.hpp"
#include "solvers/radial/transient_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace searle::solvers::axisymmetric {
namespace {

namespace flow = laws::flow;

const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
constexpr double density = 1100.0;
const flow::AnyFlowLaw slurry = flow::HerschelBulkley{0.5, 0.2, 0.6};

rheometry::SpeedHistory up_and_down() {
    return {.pieces = {{0.0, 0.5, 0.0, 8.0}, {0.5, 1.0, 8.0, 1.0}},
            .row_times = {0.1, 0.3, 0.5, 0.6, 0.8, 1.0}};
}

/// With the steady torques of the rows to half of the accuracy.
SwirlHistory history_of(const geometry::DinBob& rotor, const flow::AnyFlowLaw& law,
                        const rheometry::SpeedHistory& history, double accuracy,
                        const ProgressSink& progress = {}) {
    std::vector<double> torque;
    std::vector<double> error;
    for (const double time : history.row_times) {
        const double speed = history.speed_at(time);
        const CreepingTorque steady = speed == 0.0 ? CreepingTorque{}
                                                   : creeping_torque(rotor, law, std::abs(speed),
                                                                     {.accuracy = 0.5 * accuracy});
        torque.push_back(std::copysign(steady.torque, speed));
        error.push_back(speed == 0.0 ? 0.0 : steady.error);
    }
    return swirl_history(rotor, law, density, history, accuracy, {torque, error}, {}, progress);
}

/// Independent method: the Newtonian fluid's modes, exact in time (SwirlResponse).
TEST(SwirlHistory, of_a_newtonian_fluid_is_that_of_its_modes_at_three_accuracies) {
    const double viscosity = 0.05;
    const auto exact = transient_swirl(bob, viscosity, density, up_and_down(), 1e-6);
    ASSERT_TRUE(exact.reached);
    for (const double accuracy : {3e-2, 3e-3, 3e-4}) {
        const SwirlHistory found =
            history_of(bob, flow::Newtonian{viscosity}, up_and_down(), accuracy);
        EXPECT_TRUE(found.reached) << accuracy;
        ASSERT_EQ(found.torque.size(), exact.torque.size());
        for (std::size_t k = 0; k < exact.torque.size(); ++k) {
            EXPECT_LE(std::abs(found.torque[k] - exact.torque[k]), found.error[k] + exact.error[k])
                << accuracy << ' ' << k;
        }
    }
}

/// Independent method: what a longer bob adds far from both ends is the torque of a slice, which
/// the radial solver has by a discretisation of its own (fluxes, moving yield surfaces split
/// exactly). The ends are the same for both lengths. Gives the run of the shorter bob.
SwirlHistory expect_a_slice_more(const flow::AnyFlowLaw& law,
                                 const rheometry::SpeedHistory& history, double accuracy,
                                 double tolerance = std::numeric_limits<double>::infinity()) {
    const auto with_length = [&](double length) {
        geometry::DinBob longer = bob;
        longer.length_ratio = length / bob.bob_radius;
        return history_of(longer, law, history, accuracy);
    };
    const SwirlHistory small = with_length(0.042);
    const SwirlHistory large = with_length(0.063);
    EXPECT_EQ(small.levels, large.levels) << "on different levels the ends' errors do not cancel";
    EXPECT_TRUE(small.reached && large.reached);
    const geometry::ConcentricCylinders slice{
        .bob_radius = bob.bob_radius, .cup_radius = bob.cup_radius, .height = 0.021};
    const auto radial =
        radial::solve_levels(radial::rotor_gaps(slice, density), law, history, 1e-5, {});
    EXPECT_TRUE(small.torque.size() == radial.torque.size() &&
                large.torque.size() == radial.torque.size());
    for (std::size_t k = 0; k < std::min(small.torque.size(), large.torque.size()); ++k) {
        EXPECT_EQ(small.rests[k], radial.rests[k]) << k;
        if (!small.rests[k]) {
            const double added = large.torque[k] - small.torque[k];
            EXPECT_NEAR(added / radial.torque[k], 1.0, tolerance) << k;
            EXPECT_NEAR(added, radial.torque[k], small.error[k] + large.error[k] + radial.error[k])
                << k;
        }
    }
    return small;
}

TEST(SwirlHistory, of_a_longer_bob_adds_the_slice_of_the_radial_solver) {
    // Found: 1.1e-5. Most of either run's error is the ends' and cancels.
    const SwirlHistory found = expect_a_slice_more(slurry, up_and_down(), 4e-3, 5e-5);
    EXPECT_EQ(found.torque.size(), up_and_down().row_times.size());
}

/// The torque at the stop changes within the last instant; steps over the whole of it agreed with
/// each other on all levels, and were 3 % off.
TEST(SwirlHistory, a_stop_of_a_thinning_fluid_is_seen) {
    const rheometry::SpeedHistory stop{.pieces = {{0.0, 0.05, 0.0, 0.3}, {0.05, 0.1, 0.3, 0.0}},
                                       .row_times = {0.05, 0.1},
                                       .initial_speed = 0.0};
    expect_a_slice_more(flow::Cross{0.89, 0.011, 2.22, 0.434}, stop, 2e-2);
}

/// The fluid runs on and drags the rotor, its yield stress ends the flow in a finite time, and the
/// next row starts from rest.
TEST(SwirlHistory, an_abrupt_stop_is_followed_to_rest_and_beyond) {
    const rheometry::SpeedHistory stop{.pieces = {{0.0, 0.1, 0.0, 0.0}, {0.1, 0.4, 4.0, 4.0}},
                                       .row_times = {0.002, 0.08, 0.1, 0.4},
                                       .initial_speed = 8.0};
    const SwirlHistory found = expect_a_slice_more(slurry, stop, 2e-2);
    ASSERT_EQ(found.torque.size(), 4U);
    EXPECT_EQ(found.rests, (std::vector<bool>{false, true, true, false}));
    EXPECT_LT(found.torque[0], 0.0);
    EXPECT_LT(found.torque[1], 0.0);
    EXPECT_EQ(found.torque[2], found.torque[1]);
}

/// What a stop within a fifth of a millisecond leaves is a tenth of the torque before, with the
/// other sign: errors of steps and of elements, each 2 % of it, cancelled in the difference of two
/// levels.
TEST(SwirlHistory, what_is_left_where_the_torque_turns_is_judged_by_three_levels) {
    const geometry::DinBob narrow{.bob_radius = 0.0226285198, .cup_radius = 0.0232333801};
    const flow::Bingham thick{0.384474865, 12.7300125};
    const double time = 2.05934e-4;
    const double speed = 0.0187;
    const rheometry::SpeedHistory stop{
        .pieces = {{0.0, time, 0.0, speed}, {time, 2.0 * time, speed, 0.0}},
        .row_times = {time, 2.0 * time}};
    const SwirlHistory found = history_of(narrow, thick, stop, 5e-2);
    ASSERT_EQ(found.torque.size(), 2U);
    EXPECT_GE(found.levels, 3);
    // Of runs at 5e-3 and 2e-3, which differ by 1e-9 and 5e-8; their bars are 3e-6.
    const double finer[] = {2.42949e-3, -2.0365e-4};
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_LE(std::abs(found.torque[k] - finer[k]), found.error[k]) << k;
        // What changed at the stop widens no row before it by the same share.
        EXPECT_LE(found.error[k], (k == 0 ? 0.01 : 0.06) * std::abs(found.torque[k])) << k;
    }
}

TEST(SwirlHistory, of_a_yield_stress_fluid_ends_in_the_steady_torque) {
    rheometry::SpeedHistory hold;
    hold.pieces = {{0.0, 0.1, 0.0, 4.0}, {0.1, 3.0, 4.0, 4.0}};
    hold.row_times = {3.0};
    const SwirlHistory found = history_of(bob, slurry, hold, 1e-3);
    ASSERT_TRUE(found.reached);
    const CreepingTorque steady = creeping_torque(bob, slurry, 4.0, {.accuracy = 1e-4});
    EXPECT_LE(std::abs(found.torque[0] - steady.torque), found.error[0] + steady.error);
    // Of the last level alone, without the known steady torque.
    EXPECT_LE(found.steady_defect, 5e-3);
    EXPECT_GT(found.steady_defect, 0.0);
}

/// Where the fluid stops the law leaves the torque open, and the bar says so.
TEST(SwirlHistory, at_rest_the_bar_covers_what_the_yield_stress_allows) {
    rheometry::SpeedHistory stop;
    stop.pieces = {{0.0, 0.5, 0.0, 8.0}, {0.5, 1.0, 8.0, 0.0}};
    stop.row_times = {0.5, 1.0};
    const SwirlHistory found = history_of(bob, slurry, stop, 1e-2);
    ASSERT_EQ(found.torque.size(), 2U);
    EXPECT_EQ(found.rests, (std::vector<bool>{false, true}));
    const double at_yield = creeping_torque(bob, slurry, 1e-5, {.accuracy = 1e-2}).torque;
    // A hundredth above the yield stress the ends carry a little more yet.
    EXPECT_NEAR(found.torque[1], at_yield, 0.04 * at_yield);
    EXPECT_GE(found.torque[1] + found.error[1], 0.9 * at_yield);
    EXPECT_LE(found.torque[1] - found.error[1], -0.9 * at_yield);
}

/// The yield stress times the bob's surface is less than what the whole rotor holds; a fluid of
/// n = 0.3 flows at a millionth of the speed with twice the yield stress.
TEST(SwirlHistory, stopping_torque_is_the_yield_stress_s_whatever_the_index) {
    const double cylinder = 2.0 * M_PI * std::pow(bob.bob_radius, 2) * bob.height();
    double before = 0.0;
    for (const double index : {1.0, 0.6, 0.3}) {
        const double torque = stopping_torque(bob, flow::HerschelBulkley{1.0, 10.0, index});
        EXPECT_GT(torque, cylinder);
        EXPECT_LT(torque, 1.6 * cylinder);
        if (before > 0.0) {
            EXPECT_NEAR(torque / before, 1.0, 0.03) << index;
        }
        before = torque;
    }
}

/// Ctrl-C at any call of the progress, those of the steady flow that comes first included.
TEST(SwirlHistory, an_interruption_at_any_time_hands_out_whole_levels_or_nothing) {
    for (const int calls : {0, 2, 30}) {
        int left = calls;
        const SwirlHistory found =
            history_of(bob, slurry, up_and_down(), 1e-2, [&left](double, std::string_view) {
                if (left-- == 0) {
                    throw Interrupted();
                }
            });
        EXPECT_TRUE(found.interrupted) << calls;
        EXPECT_FALSE(found.reached) << calls;
        EXPECT_TRUE(found.torque.empty() || found.torque.size() == 6U) << calls;
        EXPECT_EQ(found.error.size(), found.torque.size()) << calls;
    }
}

/// Order in time on one mesh: with the tolerance the error of the torque falls as the steps' fourth
/// power, observed between 3 and 6 with adaptive steps.
TEST(SwirlStepper, torque_converges_with_the_fourth_order_in_time) {
    const flow::AnyFlowLaw thinning = flow::PowerLaw{0.2, 0.6};
    const double speed = 8.0;
    const SectionShape shape = bob;
    const double wall_rate = shape.wall_rate(thinning, speed);
    const SwirlLaw law(thinning, speed, wall_rate / speed);
    const SectionMesh mesh = section_of(shape, graded_lines(shape, {.smallest = 0.1}));
    const SectionSpace space(mesh, Field::rotation, 4, 6);
    const auto run = [&](double tolerance) {
        SwirlStepper stepper(
            space, law,
            {.tolerance = tolerance,
             .inertia = density * std::pow(shape.unit(), 2) * speed / law.stress_scale(),
             .rounding = 1e-5 * wall_rate / speed});
        EXPECT_TRUE(stepper.start_steadily(0.5));
        EXPECT_TRUE(stepper.begin({.start_time = 0.0, .speed = 0.5, .acceleration = 1.0}, 1e-6));
        while (stepper.time() < 0.4) {
            if (!stepper.step(0.4)) {
                ADD_FAILURE();
                break;
            }
        }
        return std::pair{stepper.torque(), static_cast<double>(stepper.steps())};
    };
    const double exact = run(1e-9).first;
    const auto [coarse, coarse_steps] = run(1e-3);
    const auto [middle, middle_steps] = run(1e-5);
    const auto [fine, fine_steps] = run(1e-7);
    EXPECT_LT(std::abs(middle - exact), 0.1 * std::abs(coarse - exact));
    EXPECT_LT(std::abs(fine - exact), 0.1 * std::abs(middle - exact));
    const double order = std::log(std::abs(coarse - exact) / std::abs(fine - exact)) /
                         std::log(fine_steps / coarse_steps);
    EXPECT_GT(order, 3.0);
}

} // namespace
} // namespace searle::solvers::axisymmetric
