#include "solvers/meridional/vortex_run.hpp"
#include "solvers/meridional/vortex_solver.hpp"
#include "solvers/plan.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace searle::solvers::meridional {
namespace {

using rheometry::SpeedKind;

/// Steps of glycerol and water from 80 % to 120 % of the onset of vortices, held until long after
/// they are steady.
Scene steps_over_the_onset() {
    Scene scene;
    scene.instrument = geometry::ConcentricCylinders{0.014, 0.016, 0.042};
    scene.fluid = {laws::flow::Newtonian{1e-2}, 1150.0};
    const double onset = make_plan([&] {
                             scene.protocol.program = rheometry::Steps{{{400.0}}, 1.0};
                             return scene;
                         }())
                             .rows[0]
                             .taylor_ratio /
                         400.0;
    rheometry::Steps steps{{}, 30.0};
    for (const double ratio : {0.8, 0.97, 1.2}) {
        steps.speeds.push_back({ratio / onset, SpeedKind::shear_rate});
    }
    scene.protocol.program = steps;
    return scene;
}

/// Just below the onset a rotor that is uneven by solver.disturbance carries a little more torque
/// than an even one. Instruments have neither: the bar holds both.
TEST(VortexRows, just_below_the_onset_the_bar_holds_the_laminar_torque) {
    const Scene scene = steps_over_the_onset();
    const Plan plan = make_plan(scene);
    ASSERT_NEAR(plan.rows[1].taylor_ratio, 0.97, 1e-6);
    const auto rows = solve_with_vortices(scene, plan, {}).history.rows;
    const auto laminar = radial::solve_radial(scene, plan, {}).history.rows;
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].torque, laminar[0].torque);
    EXPECT_EQ(rows[0].torque_error, laminar[0].torque_error);
    const double added = rows[1].torque - laminar[1].torque;
    EXPECT_GT(added, 10.0 * laminar[1].torque_error);
    EXPECT_GE(rows[1].torque_error, added);
    EXPECT_LT(rows[1].torque_error, 1e-3 * rows[1].torque);
    EXPECT_GT(rows[2].torque, 1.1 * laminar[2].torque);
}

bool warns_of(const Scene& scene, std::string_view words) {
    return std::ranges::any_of(make_plan(scene).warnings, [&](const std::string& warning) {
        return warning.find(words) != std::string::npos;
    });
}

TEST(VortexRows, a_wavelength_that_fits_nowhere_or_serves_nothing_is_told) {
    Scene scene = steps_over_the_onset();
    EXPECT_FALSE(warns_of(scene, "vortex_wavelength"));
    scene.solver.vortex_wavelength = 0.004;
    EXPECT_FALSE(warns_of(scene, "vortex_wavelength"));
    scene.solver.vortex_wavelength = 0.4;
    EXPECT_TRUE(warns_of(scene, "is 200 mm high, and the gap only 42 mm"));
    scene.solver.model = Model::radial;
    EXPECT_TRUE(warns_of(scene, "solver.vortex_wavelength is not used"));
}

/// Past the onset a yield-stress fluid's vortices are not solved, whatever model is asked for but
/// the one without.
TEST(VortexRows, what_is_left_out_of_a_yield_stress_fluid_is_in_the_bar) {
    Scene scene = steps_over_the_onset();
    scene.fluid.law = laws::flow::Bingham{1e-3, 1e-2};
    const auto bar = [&](Model model) {
        scene.solver.model = model;
        const Plan plan = make_plan(scene);
        EXPECT_FALSE(plan.vortices);
        EXPECT_GT(plan.rows[2].taylor_ratio, 1.1);
        auto report = radial::solve_radial(scene, plan, {});
        doubt_vortices_left_out(scene, plan, report);
        return report.history.rows[2].torque_error / report.history.rows[2].torque;
    };
    EXPECT_GT(bar(Model::automatic), 0.1);
    EXPECT_EQ(bar(Model::axisymmetric), bar(Model::automatic));
    EXPECT_LT(bar(Model::radial), 1e-3);
}

/// Once vortices have died, the torque is the laminar one, which the radial solver knows better;
/// and where it passes through zero a cell's steps, as long as the ramp lets them be, were 1 % off.
TEST(VortexRows,
     after_vortices_have_died_the_torque_is_the_laminar_one_and_the_bar_holds_the_cell) {
    Scene scene = steps_over_the_onset();
    scene.fluid.law = laws::flow::CarreauYasuda{1.2e-2, 4e-3, 3e-2, 0.6, 0.63};
    scene.solver.accuracy = 5e-2;
    const double fastest = 420.0;
    scene.protocol.program =
        rheometry::Segments{{{{fastest, SpeedKind::shear_rate}, 600.0, 4},
                             {{-0.2 * fastest, SpeedKind::shear_rate}, 600.0, 7}}};
    const Plan plan = make_plan(scene);
    ASSERT_GT(plan.rows[3].taylor_ratio, 1.05);
    const auto rows = solve_with_vortices(scene, plan, {}).history.rows;
    const auto laminar = radial::solve_radial(scene, plan, {}).history.rows;
    ASSERT_EQ(rows.size(), 11U);
    EXPECT_GT(rows[3].torque, 1.05 * laminar[3].torque);
    int after = 0;
    for (std::size_t k = 4; k < rows.size(); ++k) {
        if (plan.rows[k].taylor_ratio < 0.9) {
            ++after;
            EXPECT_EQ(rows[k].torque, laminar[k].torque) << k;
            EXPECT_GT(rows[k].torque_error, laminar[k].torque_error) << k;
        }
    }
    EXPECT_EQ(after, 4);
}

struct Stopped {
    VortexRun run;
    bool thrown{};
};

Stopped stopped_in_level(int number) {
    const radial::AnnularGap gap{0.014, 0.016};
    rheometry::SpeedHistory hold;
    hold.pieces = {{0.0, 1.0, 0.0, 60.0}, {1.0, 20.0, 60.0, 60.0}};
    hold.row_times = {0.5, 20.0};
    int level = 0;
    double before = 1.0;
    const ProgressSink stop = [&](double fraction, std::string_view) {
        level += fraction < before ? 1 : 0;
        before = fraction;
        if (level == number && fraction > 0.5) {
            throw Interrupted();
        }
    };
    Stopped stopped;
    try {
        const std::vector<double> accuracies(2, 1e-6);
        stopped.run = vortex_run(gap, 0.004, laws::flow::Newtonian{1e-2}, 1150.0, 1e-3, hold,
                                 accuracies, {}, stop);
    } catch (const Interrupted&) {
        stopped.thrown = true;
    }
    return stopped;
}

TEST(VortexRun, what_two_levels_found_outlives_an_interruption) {
    EXPECT_TRUE(stopped_in_level(1).thrown);
    EXPECT_TRUE(stopped_in_level(2).thrown);
    const Stopped third = stopped_in_level(3);
    ASSERT_FALSE(third.thrown);
    EXPECT_TRUE(third.run.interrupted);
    EXPECT_FALSE(third.run.reached);
    EXPECT_EQ(third.run.levels, 2);
    ASSERT_EQ(third.run.torque.size(), 2U);
    EXPECT_LT(third.run.error[1], 0.1 * third.run.torque[1]);
}

} // namespace
} // namespace searle::solvers::meridional
