#include "rheometry/fields/section_fields.hpp"
#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/swirl_fields.hpp"
#include "solvers/axisymmetric/swirl_level.hpp"
#include "solvers/axisymmetric/swirl_response.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "tests/solvers/section_power.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace searle::solvers {
namespace {

namespace flow = laws::flow;
namespace fields = rheometry::fields;

Scene scene_in(const geometry::Instrument& instrument, const flow::AnyFlowLaw& law,
               const rheometry::Protocol& protocol) {
    Scene scene;
    scene.instrument = instrument;
    scene.fluid = {law, 1000.0};
    scene.protocol = protocol;
    scene.conversion.definition = rheometry::default_definition(instrument);
    scene.conversion.end_factor = 1.0;
    scene.output.fields = true;
    scene.output.field_rows = 2;
    return scene;
}

rheometry::Protocol steady_at(double speed) {
    rheometry::Steps steps;
    steps.speeds = {{speed, rheometry::SpeedKind::drive}};
    return {.program = steps};
}

/// v = A r + B / r with A = -w R1^2 / (R2^2 - R1^2), B = -A R2^2; rate = 2 B / r^2.
TEST(GapFields, newtonian_profile_matches_the_closed_form) {
    const geometry::ConcentricCylinders gap{0.014, 0.021, 0.042};
    const Scene scene = scene_in(gap, flow::Newtonian{0.01}, steady_at(3.0));
    const Plan plan = make_plan(scene);
    const auto report = radial::solve_radial(scene, plan, {});
    ASSERT_EQ(report.fields.size(), 1U);
    const fields::SectionFields& section = report.fields.front();
    const double a = -3.0 * 0.014 * 0.014 / (0.021 * 0.021 - 0.014 * 0.014);
    const double b = -a * 0.021 * 0.021;
    ASSERT_FALSE(section.points.empty());
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        const double r = section.points[k].r;
        EXPECT_NEAR(section.find("velocity")->values[3 * k + 1], a * r + b / r, 1e-11);
        EXPECT_NEAR(section.find("shear_rate")->values[k], 2.0 * b / (r * r), 1e-8);
        EXPECT_NEAR(section.find("swirl_stress")->values[3 * k], -0.02 * b / (r * r), 1e-10);
        EXPECT_NEAR(section.find("viscosity")->values[k], 0.01, 1e-12);
    }
}

/// The rotor's wall turns with the drive and the fixed walls stand still, on both sides of a double
/// gap; where the stress is below the yield stress nothing is sheared.
TEST(GapFields, a_yield_stress_fluid_in_a_double_gap_sticks_to_its_walls) {
    const geometry::DoubleGap gaps{{0.010, 0.014, 0.016, 0.024}, 0.042};
    const Scene scene = scene_in(gaps, flow::Bingham{10.0, 1.0}, steady_at(-0.5));
    const auto report = radial::solve_radial(scene, make_plan(scene), {});
    ASSERT_EQ(report.fields.size(), 1U);
    const fields::SectionFields& section = report.fields.front();
    const auto& turn = section.find("angular_velocity")->values;
    const auto& yielded = section.find("yielded")->values;
    const auto& rate = section.find("shear_rate")->values;
    std::size_t rigid = 0;
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        const double r = section.points[k].r;
        if (r == 0.014 || r == 0.016) {
            EXPECT_NEAR(turn[k], -0.5, 1e-6);
        } else if (r == 0.010 || r == 0.024) {
            EXPECT_NEAR(turn[k], 0.0, 1e-6);
        }
        EXPECT_EQ(yielded[k] == 1.0, rate[k] > 0.0);
        EXPECT_EQ(std::isnan(section.find("viscosity")->values[k]), yielded[k] == 0.0);
        rigid += yielded[k] == 0.0 ? 1U : 0U;
    }
    EXPECT_GT(rigid, 0U);
}

/// With inertia: at the end of a long hold the profile is the steady one.
TEST(GapFields, a_transient_row_long_after_a_step_is_the_steady_one) {
    const geometry::ConcentricCylinders gap{0.014, 0.016, 0.042};
    rheometry::Segments segments;
    const rheometry::ProtocolSpeed turning{5.0, rheometry::SpeedKind::drive};
    segments.segments = {{.to = turning, .duration = 0.01, .points = 2},
                         {.to = turning, .duration = 20.0, .points = 2}};
    Scene scene = scene_in(gap, flow::PowerLaw{0.01, 0.8}, {.program = segments});
    scene.solver.model = Model::radial;
    const Plan plan = make_plan(scene);
    const auto report = radial::solve_radial(scene, plan, {});
    ASSERT_TRUE(report.transient);
    ASSERT_EQ(report.fields.size(), 2U);
    EXPECT_EQ(report.fields[0].row, 2U);
    EXPECT_EQ(report.fields[1].row, 4U);
    const Scene steady_scene = scene_in(gap, flow::PowerLaw{0.01, 0.8}, steady_at(5.0));
    const auto steady = radial::solve_radial(steady_scene, make_plan(steady_scene), {});
    const auto middle = [](const fields::SectionFields& section) {
        const auto& turn = section.find("angular_velocity")->values;
        for (std::size_t k = 0; k + 1 < section.points.size(); ++k) {
            const double r = section.points[k].r;
            const double next = section.points[k + 1].r;
            if (r <= 0.015 && next > 0.015) {
                return turn[k] + (turn[k + 1] - turn[k]) * (0.015 - r) / (next - r);
            }
        }
        return 0.0;
    };
    EXPECT_NEAR(middle(report.fields[1]) / middle(steady.fields[0]), 1.0, 1e-3);
    EXPECT_LT(middle(report.fields[0]), 0.9 * middle(steady.fields[0]));
}

/// Power in = power out: the integral of stress times rate over the section is torque times speed,
/// within the error of the trapezoidal rule at the edges, where rates are infinite.
TEST(SwirlFields, what_the_section_dissipates_is_what_the_drive_delivers) {
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    for (const flow::AnyFlowLaw& law :
         {flow::AnyFlowLaw{flow::Newtonian{0.1}}, flow::AnyFlowLaw{flow::PowerLaw{0.5, 0.5}},
          flow::AnyFlowLaw{flow::HerschelBulkley{5.0, 0.5, 0.5}}}) {
        const auto swirl = axisymmetric::creeping_swirl(bob, law, 2.0, {.accuracy = 1e-4});
        const auto section =
            axisymmetric::swirl_fields({.mesh = swirl.level->mesh(),
                                        .length = bob.bob_radius,
                                        .degree = swirl.level->rotation_space().degree(),
                                        .rotation = swirl.level->rotation(),
                                        .speed = -2.0,
                                        .rate_scale = 20.0,
                                        .stress_function = &swirl.level->stress_function(),
                                        .stress_scale = swirl.stress_scale},
                                       law);
        EXPECT_NEAR(dissipation(section) / (2.0 * swirl.torque.torque), 1.0, 2e-2)
            << flow::name_of(law);
        const auto& stress = section.find("swirl_stress")->values;
        const auto& turn = section.find("angular_velocity")->values;
        std::size_t on_rotor = 0;
        for (const fields::OutlineEdge& edge : section.outline) {
            const std::uint32_t k = edge.ends[0];
            if (edge.kind == fields::OutlineKind::rotor) {
                EXPECT_NEAR(turn[k], -2.0, 1e-5);
                // The bob turns backwards: its fluid is pulled along with a positive stress.
                if (section.points[k].r == bob.bob_radius && section.points[k].z > 0.01 &&
                    section.points[k].z < 0.03) {
                    EXPECT_GT(stress[3 * k], 0.0);
                    ++on_rotor;
                }
            } else if (edge.kind == fields::OutlineKind::fixed_wall) {
                EXPECT_NEAR(turn[k], 0.0, 1e-5);
            }
        }
        EXPECT_GT(on_rotor, 0U);
    }
}

/// After a long hold the modes have decayed and the field dissipates the drive's power; just after
/// the jump the fluid away from the rotor still rests.
TEST(SwirlFields, transient_modes_end_in_the_steady_flow_and_start_at_the_wall) {
    const geometry::DinBob bob{0.014, 0.0152};
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 400.0, 2.0, 2.0}};
    history.row_times = {1e-3, 400.0};
    const axisymmetric::TransientSwirl swirl =
        axisymmetric::transient_swirl(bob, 1e-3, 1000.0, history, 1e-3);
    const std::array<std::size_t, 2> rows{1, 2};
    const auto sections =
        axisymmetric::transient_fields(bob, 1e-3, 1000.0, history, swirl.resolution, rows);
    ASSERT_EQ(sections.size(), 2U);
    EXPECT_NEAR(dissipation(sections[1]) / (2.0 * swirl.torque[1]), 1.0, 2e-2);
    const auto mean_turn = [](const fields::SectionFields& section) {
        double sum = 0.0;
        for (const double each : section.find("angular_velocity")->values) {
            sum += each;
        }
        return sum / static_cast<double>(section.points.size());
    };
    EXPECT_LT(mean_turn(sections[0]), 0.8 * mean_turn(sections[1]));
    for (const auto& section : sections) {
        for (const double each : section.find("angular_velocity")->values) {
            EXPECT_LE(each, 2.0 * (1.0 + 1e-3)) << "the accuracy asked for";
        }
    }
}

} // namespace
} // namespace searle::solvers
