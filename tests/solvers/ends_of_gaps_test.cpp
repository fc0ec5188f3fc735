#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/end_factor_curve.hpp"
#include "solvers/axisymmetric/section_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers::axisymmetric {
namespace {

namespace flow = laws::flow;

SectionShape single_gap(double bottom_gap) {
    return section_shape(geometry::ConcentricCylinders{.bob_radius = 0.014,
                                                       .cup_radius = 0.015,
                                                       .height = 0.042,
                                                       .ends = true,
                                                       .bottom_gap = bottom_gap})
        .value();
}

SectionShape double_gap(double bottom_gap) {
    return section_shape(geometry::DoubleGap{.radii = {0.020, 0.02038, 0.02196, 0.02238},
                                             .height = 0.055,
                                             .ends = true,
                                             .bottom_gap = bottom_gap})
        .value();
}

/// Expected: bench/independent_end_factors.py, bilinear elements extrapolated from three grids.
TEST(EndsOfGaps, single_gap_with_a_flat_bottom_matches_independent_elements) {
    const CreepingTorque found =
        creeping_torque(single_gap(0.0028), flow::Newtonian{0.1}, 1.0, {.accuracy = 1e-5});
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(found.end_factor, 1.043464, 2e-6);
    EXPECT_LT(found.lower, found.torque);
    EXPECT_GT(found.upper, found.torque);
}

/// A flat bottom very near the floor is a parallel-plate rheometer: M = pi eta omega R^4 / (2 h) of
/// its own, and the edge adds little. c_L - 1 = R^2 (delta^2 - 1) / (8 delta^2 h L) then.
TEST(EndsOfGaps, a_bottom_near_the_floor_is_a_pair_of_plates) {
    const double h = 1e-4;
    const CreepingTorque found =
        creeping_torque(single_gap(h), flow::Newtonian{0.1}, 1.0, {.accuracy = 1e-4});
    const double delta_squared = 225.0 / 196.0;
    const double plates = 0.014 * 0.014 * (delta_squared - 1.0) / (8.0 * delta_squared * h * 0.042);
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR((found.end_factor - 1.0) / plates, 1.0, 5e-2);
    EXPECT_GT(found.end_factor - 1.0, plates);
}

TEST(EndsOfGaps, a_double_gap_has_its_torque_between_energy_bounds) {
    for (const flow::AnyFlowLaw& law :
         {flow::AnyFlowLaw{flow::Newtonian{0.1}}, flow::AnyFlowLaw{flow::PowerLaw{1.0, 0.5}}}) {
        const CreepingTorque found =
            creeping_torque(double_gap(0.003), law, 1.0, {.accuracy = 1e-5});
        EXPECT_TRUE(found.reached);
        EXPECT_LT((found.upper - found.lower) / found.torque, 1e-5);
        EXPECT_LE(found.lower, found.torque);
        EXPECT_GE(found.upper, found.torque);
        EXPECT_GT(found.end_factor, 1.0);
    }
}

TEST(EndsOfGaps, a_slice_has_no_section_and_a_box_neither) {
    EXPECT_FALSE(section_shape(geometry::ConcentricCylinders{0.014, 0.015, 0.042}).has_value());
    EXPECT_FALSE(section_shape(geometry::DoubleGap{}).has_value());
    EXPECT_FALSE(section_shape(geometry::Box{}).has_value());
    EXPECT_TRUE(section_shape(geometry::DinBob{0.014, 0.0152}).has_value());
}

/// An interruption keeps the speeds that were solved, and a curve whose second degree is whole.
TEST(EndFactorCurve, an_interruption_keeps_what_was_solved) {
    const flow::AnyFlowLaw law = flow::HerschelBulkley{5.0, 0.5, 0.5};
    const geometry::DinBob bob{0.014, 0.0152};
    const SectionShape shape = bob;
    int calls = 0;
    const std::vector<double> speeds{0.5, 1.0, 2.0, 4.0};
    const ProgressSink stop_later = [&](double fraction, std::string_view) {
        calls += fraction == 0.0 ? 1 : 0;
        if (calls > 2) {
            throw Interrupted();
        }
    };
    const EndFactorCurve curve(shape, law, speeds, 1e-2, stop_later);
    EXPECT_TRUE(curve.interrupted());
    EXPECT_TRUE(curve.has(0.5));
    EXPECT_TRUE(curve.has(1.0));
    EXPECT_FALSE(curve.has(2.0));
    EXPECT_GT(curve.at(1.0).end_factor, 1.2);
}

} // namespace
} // namespace searle::solvers::axisymmetric
