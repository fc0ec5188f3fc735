#include "solvers/plan.hpp"
#include "solvers/plan_chambers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::solvers {
namespace {

/// A disc close above a floor is started suddenly: each ring is a plane gap, whose wall stress is
/// mu r omega / h (1 + 2 sum exp(-n^2 pi^2 nu t / h^2)), so the torque beyond the steady one begins
/// with pi mu omega R^4 / h times that sum. The plan takes 6 / pi^2 inertia / decay time for it.
TEST(PlanChambers, below_a_disc_near_the_floor_are_plane_gaps) {
    constexpr double viscosity = 0.02;
    constexpr double density = 1100.0;
    constexpr double radius = 0.014;
    constexpr double height = 1e-4;
    const geometry::ConcentricCylinders disc{.bob_radius = radius,
                                             .cup_radius = 0.015,
                                             .height = 0.042,
                                             .ends = true,
                                             .bottom_gap = height};
    const auto [below, above] =
        chamber_responses(disc, {laws::flow::Newtonian{viscosity}, density}, 3.0);
    EXPECT_EQ(above.inertia, 0.0);
    const double expected = std::numbers::pi * viscosity * std::pow(radius, 4) / height;
    // The cup's wall adds (3.83 h / pi R_cup)^2 = 7e-5 to the rate of decay.
    EXPECT_NEAR(6.0 / std::pow(std::numbers::pi, 2) * below.inertia / below.decay_time / expected,
                1.0, 1e-4);
    EXPECT_NEAR(below.decay_time, density * height * height / viscosity / 9.8696,
                1e-4 * below.decay_time);
}

TEST(PlanChambers, a_slice_has_none) {
    const Fluid fluid{laws::flow::Newtonian{1.0}, 1000.0};
    for (const GapResponse& chamber :
         chamber_responses(geometry::ConcentricCylinders{0.014, 0.015, 0.042}, fluid, 1.0)) {
        EXPECT_EQ(chamber.inertia, 0.0);
    }
}

/// Scene 1476 of seed 9 of `searle stress`: the gap has forgotten a jump after 6 ms, the fluid
/// below the bob not yet. Taken as steady the rows were 0.14 % off, with bars of 0.04 %.
TEST(PlanChambers, fluid_below_a_bob_that_still_speeds_up_is_solved_in_time) {
    Scene scene;
    scene.instrument =
        geometry::DinBob{.bob_radius = 0.0101360451, .cup_radius = 1.35425 * 0.0101360451};
    scene.fluid = {laws::flow::PowerLaw{13.6283779, 0.693886}, 2082.33};
    scene.protocol.program = rheometry::Steps{
        {{14.7916, rheometry::SpeedKind::shear_rate}, {27.2164, rheometry::SpeedKind::shear_rate}},
        0.00614724};
    scene.solver.accuracy = 0.0259;
    EXPECT_TRUE(make_plan(scene).transient);
    auto& steps = std::get<rheometry::Steps>(scene.protocol.program);
    steps.hold = 0.1;
    EXPECT_FALSE(make_plan(scene).transient);
}

} // namespace
} // namespace searle::solvers
