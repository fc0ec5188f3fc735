#include "rheometry/fields/section_fields.hpp"
#include "solvers/meridional/bob_solver.hpp"
#include "solvers/meridional/vortex_solver.hpp"
#include "solvers/plan.hpp"
#include "tests/solvers/section_power.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace searle::solvers::meridional {
namespace {

namespace fields = rheometry::fields;
using rheometry::SpeedKind;

Scene scene_in(const geometry::Instrument& instrument, double viscosity, double speed,
               std::optional<double> hold) {
    Scene scene;
    scene.instrument = instrument;
    scene.fluid = {laws::flow::Newtonian{viscosity}, 1000.0};
    rheometry::Steps steps{{{speed, SpeedKind::drive}}, hold};
    scene.protocol.program = steps;
    scene.conversion.definition = rheometry::default_definition(instrument);
    scene.conversion.end_factor = 1.0;
    scene.solver.accuracy = 1e-3;
    scene.output.fields = true;
    return scene;
}

double height_of(const fields::SectionFields& section) {
    const auto [low, high] =
        std::ranges::minmax_element(section.points, {}, &fields::SectionPoint::z);
    return high->z - low->z;
}

bool has_kind(const fields::SectionFields& section, fields::OutlineKind kind) {
    return std::ranges::any_of(section.outline,
                               [&](const auto& edge) { return edge.kind == kind; });
}

/// 1.3 times the onset of 14 in 16 mm (Re_c = 118.157, docs/plan.md), with nu = 1e-5 m^2/s.
constexpr double vortex_speed = 1.3 * 118.157 * 1e-5 / (0.014 * 0.002);

void expect_vortex_that_takes_up_the_power(std::optional<double> hold) {
    const geometry::ConcentricCylinders gap{0.014, 0.016, 0.042};
    const Scene scene = scene_in(gap, 1e-2, vortex_speed, hold);
    const auto report = solve_with_vortices(scene, make_plan(scene), {});
    ASSERT_EQ(report.fields.size(), 1U);
    const fields::SectionFields& vortex = report.fields.front();
    EXPECT_EQ(vortex.row, 1U);
    EXPECT_DOUBLE_EQ(vortex.speed, vortex_speed);
    ASSERT_NE(vortex.find("stream_function"), nullptr);
    EXPECT_FALSE(has_kind(vortex, fields::OutlineKind::free_surface));
    EXPECT_TRUE(has_kind(vortex, fields::OutlineKind::open_end));
    // The laminar flow would take up two thirds of it.
    const double power = report.history.rows[0].torque * vortex_speed;
    EXPECT_NEAR(dissipation(vortex) * 0.042 / height_of(vortex), power, 0.01 * power);
    EXPECT_EQ(report.transient, hold.has_value());
}

TEST(VortexFields, a_steady_vortex_takes_up_what_the_drive_delivers) {
    expect_vortex_that_takes_up_the_power({});
}

TEST(VortexFields, a_vortex_in_time_takes_up_what_the_drive_delivers_in_the_end) {
    expect_vortex_that_takes_up_the_power(60.0);
}

TEST(VortexFields, rows_below_the_onset_show_the_laminar_gap) {
    const geometry::ConcentricCylinders gap{0.014, 0.016, 0.042};
    Scene scene = scene_in(gap, 1e-2, vortex_speed, {});
    scene.protocol.program = rheometry::Steps{
        {{-0.5 * vortex_speed, SpeedKind::drive}, {vortex_speed, SpeedKind::drive}}, {}};
    scene.output.field_rows = 2;
    const auto report = solve_with_vortices(scene, make_plan(scene), {});
    ASSERT_EQ(report.fields.size(), 2U);
    EXPECT_EQ(report.fields[0].find("stream_function"), nullptr);
    EXPECT_DOUBLE_EQ(height_of(report.fields[0]), 0.042);
    EXPECT_NE(report.fields[1].find("stream_function"), nullptr);
}

/// An ISO bob at omega R^2 / nu = 470.
TEST(FlowFields, secondary_flow_in_time_ends_as_the_steady_one_and_takes_up_the_power) {
    geometry::DinBob bob;
    bob.bob_radius = 0.014;
    bob.cup_radius = 0.014 * 1.0847;
    const double speed = 12.0;
    const Scene held = scene_in(bob, 5e-3, speed, 15.0);
    const Scene steady = scene_in(bob, 5e-3, speed, {});
    const auto in_time = solve_bob(held, make_plan(held), {}).solution;
    const auto at_once = solve_bob(steady, make_plan(steady), {}).solution;
    ASSERT_EQ(in_time.fields.size(), 1U);
    ASSERT_EQ(at_once.fields.size(), 1U);
    EXPECT_TRUE(in_time.transient);
    EXPECT_DOUBLE_EQ(in_time.fields[0].time, 15.0);
    const auto strongest = [](const fields::SectionFields& section) {
        const auto& values = section.find("stream_function")->values;
        return *std::ranges::max_element(values, {}, [](double each) { return std::abs(each); });
    };
    EXPECT_NEAR(strongest(in_time.fields[0]), strongest(at_once.fields[0]),
                0.02 * std::abs(strongest(at_once.fields[0])));
    for (const auto* report : {&in_time, &at_once}) {
        const double power = report->history.rows[0].torque * speed;
        EXPECT_NEAR(dissipation(report->fields[0]), power, 0.02 * power);
    }
}

} // namespace
} // namespace searle::solvers::meridional
