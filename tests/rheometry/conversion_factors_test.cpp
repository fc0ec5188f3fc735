#include "rheometry/conversion/conversion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace searle::rheometry {
namespace {

constexpr double pi = std::numbers::pi;

geometry::ConcentricCylinders single_gap(double delta) {
    return {.bob_radius = 0.014, .cup_radius = delta * 0.014, .height = 0.042};
}

// physics.md section 1: 16243.2702 Pa/(N m) and 12.187215 1/rad for the TA DIN cylinder 14/15.2/42
// mm, c_L 1.10, the digits as they stand there.
TEST(conversion_factors, ta_din_cylinder_matches_its_own_factors) {
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const Conversion conversion = conversion_for(bob, {});
    EXPECT_EQ(conversion.definition, RateDefinition::iso_3219);
    EXPECT_EQ(conversion.end_factor, 1.10);
    EXPECT_NEAR(conversion.stress_per_torque, 16243.2702, 0.5e-4);
    EXPECT_NEAR(conversion.rate_per_speed, 12.187215, 0.5e-6);
}

// physics.md section 1, ISO geometry delta = 1.0847: 12.3267 (ISO), 13.3267 (bob), stress 0.0446098
// M/R^3 with L = 3R and c_L = 1.10. 11.3267 is the cup's: twice the ISO factor less the bob's.
TEST(conversion_factors, standard_geometry_matches_the_published_factors) {
    const geometry::DinBob bob{.bob_radius = 0.0125, .cup_radius = 1.0847 * 0.0125};
    const Conversion iso = conversion_for(bob, {});
    const Conversion wall = conversion_for(bob, {.definition = RateDefinition::bob_wall});
    EXPECT_NEAR(iso.rate_per_speed, 12.3267, 0.5e-4);
    EXPECT_NEAR(wall.rate_per_speed, 13.3267, 0.5e-4);
    EXPECT_NEAR(2.0 * iso.rate_per_speed - wall.rate_per_speed, 11.3267, 0.5e-4);
    EXPECT_NEAR(iso.stress_per_torque * std::pow(0.0125, 3), 0.0446098, 0.5e-7);
}

// Newtonian torque in one gap: 4 pi eta omega L / (1/Rb^2 - 1/Rc^2) (textbook closed form).
TEST(conversion_factors, every_definition_of_a_single_gap_is_exact_for_a_newtonian_fluid) {
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> exponent(-6.0, 1.3);
    for (int scene = 0; scene < 1000; ++scene) {
        const double delta = 1.0 + std::pow(10.0, exponent(random));
        const geometry::ConcentricCylinders gap = single_gap(delta);
        const double viscosity = 0.37;
        const double omega = 2.5;
        const double width = gap.cup_radius - gap.bob_radius;
        const double torque = 4.0 * pi * viscosity * omega * gap.height * gap.bob_radius *
                              gap.bob_radius * gap.cup_radius * gap.cup_radius /
                              (width * (gap.cup_radius + gap.bob_radius));
        for (const RateDefinition definition :
             {RateDefinition::bob_wall, RateDefinition::iso_3219, RateDefinition::mean_radius}) {
            const Conversion conversion = conversion_for(gap, {.definition = definition});
            EXPECT_NEAR(conversion.shear_stress(torque) / conversion.shear_rate(omega), viscosity,
                        4e-15 * viscosity)
                << name_of(definition) << " delta - 1 = " << delta - 1.0;
        }
    }
}

// As the gap narrows all three conventions tend to speed over gap and force over area of the
// unrolled gap, with a relative difference of the order of (delta - 1).
TEST(conversion_factors, definitions_agree_in_a_gap_of_one_millionth) {
    const double relative_gap = 1e-6;
    const geometry::ConcentricCylinders gap = single_gap(1.0 + relative_gap);
    const double width = gap.cup_radius - gap.bob_radius;
    for (const RateDefinition definition :
         {RateDefinition::bob_wall, RateDefinition::iso_3219, RateDefinition::mean_radius}) {
        const Conversion conversion = conversion_for(gap, {.definition = definition});
        EXPECT_NEAR(conversion.rate_per_speed * width / gap.bob_radius, 1.0, 2.0 * relative_gap);
        EXPECT_NEAR(conversion.stress_per_torque * 2.0 * pi * gap.height * gap.bob_radius *
                        gap.bob_radius,
                    1.0, 2.0 * relative_gap);
    }
}

// physics.md section 1: 4 pi eta omega L [R1^2 R2^2/(R2^2 - R1^2) + R3^2 R4^2/(R4^2 - R3^2)].
TEST(conversion_factors, double_gap_is_exact_for_a_newtonian_fluid_whatever_the_radii) {
    for (const auto& radii : std::vector<std::array<double, 4>>{{0.020, 0.02038, 0.02196, 0.02238},
                                                                {0.010, 0.0130, 0.0140, 0.0145},
                                                                {0.005, 0.0051, 0.0200, 0.0400}}) {
        const geometry::DoubleGap gap{.radii = radii, .height = 0.0555};
        const auto& [r1, r2, r3, r4] = radii;
        const double viscosity = 1.0016e-3;
        const double omega = 12.0;
        const double torque =
            4.0 * pi * viscosity * omega * gap.height *
            (r1 * r1 * r2 * r2 / (r2 * r2 - r1 * r1) + r3 * r3 * r4 * r4 / (r4 * r4 - r3 * r3));
        const Conversion conversion = conversion_for(gap, {});
        EXPECT_NEAR(conversion.shear_stress(torque) / conversion.shear_rate(omega), viscosity,
                    2e-14 * viscosity);
    }
}

// physics.md section 1: with R2/R1 = R4/R3 = delta the pair is the standards' own.
TEST(conversion_factors, double_gap_equals_the_standard_pair_for_equal_ratios) {
    const double delta = 1.02;
    const geometry::DoubleGap gap{.radii = {0.020, 0.020 * delta, 0.022, 0.022 * delta},
                                  .height = 0.05};
    const Conversion conversion = conversion_for(gap, {.end_factor = 1.03});
    const double r2 = gap.radii[1];
    const double r3 = gap.radii[2];
    EXPECT_NEAR(conversion.stress_per_torque,
                (1.0 + delta * delta) / (delta * delta * r3 * r3 + r2 * r2) /
                    (4.0 * pi * gap.height * 1.03),
                1e-12 * conversion.stress_per_torque);
    EXPECT_NEAR(conversion.rate_per_speed, (1.0 + delta * delta) / (delta * delta - 1.0),
                1e-12 * conversion.rate_per_speed);
}

TEST(conversion_factors, box_is_force_over_area_and_speed_over_gap) {
    const Conversion conversion =
        conversion_for(geometry::Box{.gap = 1e-3, .length = 0.02, .width = 0.03}, {});
    EXPECT_DOUBLE_EQ(conversion.stress_per_torque, 1.0 / 6e-4);
    EXPECT_DOUBLE_EQ(conversion.rate_per_speed, 1000.0);
}

TEST(conversion_factors, end_factor_divides_the_stress_alone) {
    const Conversion without = conversion_for(single_gap(1.1), {});
    const Conversion with = conversion_for(single_gap(1.1), {.end_factor = 1.25});
    EXPECT_DOUBLE_EQ(with.stress_per_torque * 1.25, without.stress_per_torque);
    EXPECT_EQ(with.rate_per_speed, without.rate_per_speed);
}

// Power-law torque in one gap, closed form: omega = n/2 (tau_b/K)^(1/n) (1 - delta^(-2/n)).
double iso_viscosity_error(double flow_index) {
    const geometry::ConcentricCylinders gap = single_gap(1.0847);
    const double consistency = 3.0;
    const double bob_stress = 20.0;
    const double omega = 0.5 * flow_index * std::pow(bob_stress / consistency, 1.0 / flow_index) *
                         -std::expm1(-2.0 / flow_index * std::log(1.0847));
    const double torque = bob_stress * 2.0 * pi * gap.height * gap.bob_radius * gap.bob_radius;
    const Conversion conversion = conversion_for(gap, {.definition = RateDefinition::iso_3219});
    const double law = consistency * std::pow(conversion.shear_rate(omega), flow_index);
    return conversion.shear_stress(torque) / law - 1.0;
}

// physics.md section 1: off by <= 0.033 % for n >= 0.4, 0.1 % at n = 0.3, 0.8 % at n = 0.1.
TEST(conversion_factors, iso_pair_is_nearly_exact_for_a_power_law) {
    double largest = 0.0;
    for (double flow_index = 0.4; flow_index <= 1.0; flow_index += 0.01)
        largest = std::max(largest, std::abs(iso_viscosity_error(flow_index)));
    EXPECT_LE(largest, 0.00033);
    EXPECT_GT(largest, 0.00031);
    EXPECT_NEAR(std::abs(iso_viscosity_error(0.3)), 0.001, 0.0002);
    EXPECT_NEAR(std::abs(iso_viscosity_error(0.1)), 0.008, 0.0005);
}

TEST(conversion_factors, speed_is_the_inverse_of_the_rate) {
    const Conversion conversion = conversion_for(single_gap(1.07), {});
    EXPECT_DOUBLE_EQ(conversion.speed(conversion.shear_rate(3.7)), 3.7);
}

TEST(conversion_factors, wrong_definitions_and_end_factors_are_refused) {
    const geometry::DoubleGap gap{.radii = {0.020, 0.02038, 0.02196, 0.02238}, .height = 0.05};
    EXPECT_THROW((void)conversion_for(gap, {.definition = RateDefinition::bob_wall}),
                 std::invalid_argument);
    for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_THROW((void)conversion_for(single_gap(1.1), {.end_factor = wrong}),
                     std::invalid_argument);
}

TEST(conversion_factors, computed_end_factor_is_provisional_until_it_is_given) {
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    EXPECT_TRUE(conversion_for(bob, {.end_factor_computed = true}).end_factor_provisional);
    EXPECT_FALSE(conversion_for(bob, {.end_factor = 1.0893, .end_factor_computed = true})
                     .end_factor_provisional);
}

TEST(conversion_factors, names_and_definitions_are_inverse) {
    for (const char* name : {"bob-wall", "iso-3219", "mean-radius"}) {
        ASSERT_TRUE(definition_named(name).has_value());
        EXPECT_EQ(name_of(*definition_named(name)), name);
    }
    EXPECT_FALSE(definition_named("cup-wall").has_value());
}

// Bob-wall stress in a single gap; in a double gap tau = 2 eta omega / (1 - (R3/R4)^2) at R3, from
// the Newtonian closed form of the outer gap alone.
TEST(conversion_factors, rotor_wall_stress_is_the_newtonian_wall_value) {
    const geometry::ConcentricCylinders gap = single_gap(1.2);
    EXPECT_DOUBLE_EQ(
        rotor_wall_stress_per_torque(gap, 1.1),
        conversion_for(gap, {.definition = RateDefinition::bob_wall, .end_factor = 1.1})
            .stress_per_torque);
    const geometry::DoubleGap twin{.radii = {0.010, 0.0130, 0.0140, 0.0145}, .height = 0.05};
    const Conversion conversion = conversion_for(twin, {});
    const double viscosity = 0.2;
    const double omega = 3.0;
    const double torque = viscosity * conversion.shear_rate(omega) / conversion.stress_per_torque;
    const double ratio = 0.0140 / 0.0145;
    EXPECT_NEAR(rotor_wall_stress_per_torque(twin, 1.0) * torque,
                2.0 * viscosity * omega / (1.0 - ratio * ratio), 1e-12);
}

} // namespace
} // namespace searle::rheometry
