#include "solvers/meridional/bob_solver.hpp"
#include "solvers/plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string_view>

namespace searle::solvers::meridional {
namespace {

Scene bob_in_thin_oil(double speed, std::optional<double> hold) {
    geometry::DinBob bob;
    bob.bob_radius = 0.014;
    bob.cup_radius = 0.014 * 1.0847;
    Scene scene;
    scene.instrument = bob;
    scene.fluid = {laws::flow::Newtonian{5e-3}, 1000.0};
    scene.protocol.program = rheometry::Steps{{{speed, rheometry::SpeedKind::drive}}, hold};
    scene.conversion.definition = rheometry::default_definition(scene.instrument);
    scene.conversion.end_factor_computed = true;
    scene.solver.accuracy = 1e-3;
    scene.output.fields = true;
    return scene;
}

/// Ctrl-C from when the flow's stability is looked at on.
ProgressSink stop_at_stability() {
    return [stopped = false](double, std::string_view stage) mutable {
        stopped = stopped || stage == "stability of the secondary flow";
        if (stopped) {
            throw Interrupted();
        }
    };
}

TEST(BobInterruption, steady_rows_are_whole_before_their_stability_is_asked_for) {
    const Scene scene = bob_in_thin_oil(12.0, {});
    const Plan plan = make_plan(scene);
    ASSERT_TRUE(plan.secondary_flow);
    const auto whole = solve_bob(scene, plan, {}).solution;
    const auto stopped = solve_bob(scene, plan, stop_at_stability()).solution;
    EXPECT_TRUE(stopped.interrupted);
    EXPECT_FALSE(whole.interrupted);
    ASSERT_EQ(stopped.history.rows.size(), 1U);
    EXPECT_EQ(stopped.history.rows[0].torque, whole.history.rows[0].torque);
    EXPECT_EQ(stopped.history.rows[0].torque_error, whole.history.rows[0].torque_error);
    EXPECT_EQ(stopped.worst_relative_error, whole.worst_relative_error);
}

TEST(BobInterruption, past_the_onset_the_doubt_of_vortices_stays_in_the_bar) {
    // 1.1 times the onset of the gap beside an ISO bob, 0.6 of its speed in water.
    const Scene scene = bob_in_thin_oil(47.0, {});
    const Plan plan = make_plan(scene);
    ASSERT_GT(plan.rows[0].taylor_ratio, 1.0);
    const auto stopped = solve_bob(scene, plan, stop_at_stability()).solution;
    ASSERT_EQ(stopped.history.rows.size(), 1U);
    EXPECT_GT(stopped.history.rows[0].torque_error,
              (plan.rows[0].taylor_ratio - 1.0) * stopped.history.rows[0].torque);
}

TEST(BobInterruption, rows_in_time_are_none_before_they_are_followed) {
    const Scene scene = bob_in_thin_oil(12.0, 15.0);
    const Plan plan = make_plan(scene);
    ASSERT_TRUE(plan.secondary_flow && plan.transient);
    const auto stopped = solve_bob(scene, plan, stop_at_stability());
    EXPECT_TRUE(stopped.solution.interrupted);
    EXPECT_TRUE(stopped.solution.history.rows.empty());
    EXPECT_TRUE(stopped.solution.fields.empty());
    EXPECT_TRUE(stopped.ends.empty());
}

TEST(BobInterruption, a_table_of_end_factors_has_the_speeds_that_were_finished) {
    const Scene scene = bob_in_thin_oil(12.0, {});
    const std::array speeds{1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 13.0};
    const auto whole = end_effects(scene, speeds, {});
    ASSERT_EQ(whole.rows.size(), speeds.size());
    int flows = 0;
    const auto stopped = end_effects(scene, speeds, [&](double, std::string_view stage) {
        flows += stage == "secondary flow, level 1" ? 1 : 0;
        if (flows > 6) {
            throw Interrupted();
        }
    });
    EXPECT_TRUE(stopped.interrupted);
    ASSERT_GE(stopped.rows.size(), 1U);
    ASSERT_LT(stopped.rows.size(), speeds.size());
    for (std::size_t k = 0; k < stopped.rows.size(); ++k) {
        EXPECT_EQ(stopped.rows[k].speed, whole.rows[k].speed);
        EXPECT_EQ(stopped.rows[k].with_inertia, whole.rows[k].with_inertia);
    }
}

} // namespace
} // namespace searle::solvers::meridional
