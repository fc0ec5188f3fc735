#include "rheometry/correction/gap_inversion.hpp"
#include "rheometry/correction/plug_flow_fit.hpp"
#include "rheometry/correction/rotor_rate.hpp"
#include "rheometry/correction/wall_rate.hpp"
#include "tests/rheometry/independent_gap_flow.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace searle::rheometry {
namespace {

struct Curve {
    std::vector<double> speeds;
    std::vector<double> stresses;
};

Curve curve_of(const IndependentGapFlow& flow, double from, double to, int count) {
    Curve curve;
    for (int i = 0; i < count; ++i) {
        curve.speeds.push_back(from * std::pow(to / from, static_cast<double>(i) / (count - 1)));
        curve.stresses.push_back(flow.bob_stress(curve.speeds.back()));
    }
    return curve;
}

// Closed form of a power law: omega = n/2 (tau/K)^(1/n) (1 - delta^(-2/n)), so that N = 1/n.
TEST(correction_wall_rate, power_law_formula_is_exact_for_a_power_law) {
    for (const double delta : {1.0 + 1e-6, 1.0847, 2.0, 20.0})
        for (const double flow_index : {0.1, 0.4, 1.0, 2.0}) {
            const double rate = 7.0;
            const double omega =
                0.5 * flow_index * rate * -std::expm1(-2.0 / flow_index * std::log(delta));
            EXPECT_NEAR(power_law_bob_rate(omega, 1.0 / flow_index, delta), rate, 1e-9 * rate);
            EXPECT_EQ(slope_change_correction(omega, 1.0 / flow_index, 0.0, delta), 0.0);
        }
}

// Krieger's formula against the exact rate of a Carreau fluid: with the second term the error is of
// the second order in the change of the slope, so it must be much smaller than without.
TEST(correction_wall_rate, second_term_takes_most_of_the_error_away) {
    const IndependentGapFlow flow = carreau_flow(10.0, 0.01, 0.4, 1.3);
    const double stress = 9.0;
    const auto log_speed = [&](double log_stress) {
        return std::log(flow.speed(std::exp(log_stress)));
    };
    const double at = std::log(stress);
    const double step = 1e-3;
    const double slope = (log_speed(at + step) - log_speed(at - step)) / (2.0 * step);
    const double change =
        (log_speed(at + step) - 2.0 * log_speed(at) + log_speed(at - step)) / (step * step);
    const double omega = flow.speed(stress);
    const double exact = flow.rate(stress);
    const double first = power_law_bob_rate(omega, slope, 1.3) - exact;
    const double both = first + slope_change_correction(omega, slope, change, 1.3);
    EXPECT_GT(std::abs(first), 1e-3 * exact);
    EXPECT_LT(std::abs(both), 0.1 * std::abs(first));
}

// The ratio's second derivative by differences of the ratio, on both sides of where the series
// ends.
TEST(correction_wall_rate, bernoulli_ratio_curvature_is_the_second_derivative) {
    for (const double t : {0.05, 0.0999, 0.1001, 1.0, 5.0}) {
        const double step = 1e-3;
        const double difference =
            (bernoulli_ratio(t + step) - 2.0 * bernoulli_ratio(t) + bernoulli_ratio(t - step)) /
            (step * step);
        EXPECT_NEAR(bernoulli_ratio_curvature(t), difference, 1e-7);
    }
}

// physics.md section 2, checked values.
TEST(correction_wall_rate, forward_flow_matches_the_published_values) {
    const PlugFlowLaw sheared{5.0, 0.5, 0.5};
    EXPECT_NEAR(bob_stress(sheared, 10.0, 15.0 / 14.0), 11.7802557634299, 1e-8);
    const PlugFlowLaw plugged{20.0, 2.0, 0.4};
    EXPECT_NEAR(bob_stress(plugged, 0.05, 2.0), 22.9504355400752, 1e-8);
    EXPECT_NEAR(plugged.rate(22.9504355400752), 2.64326276260158, 1e-8);
}

TEST(correction_wall_rate, forward_flow_matches_the_independent_evaluation) {
    for (const double delta : {1.001, 1.0847, 2.0, 20.0})
        for (const double flow_index : {0.1, 0.5, 1.0, 2.0})
            for (const double yield_stress : {0.0, 1.0, 100.0}) {
                const IndependentGapFlow flow =
                    herschel_bulkley_flow(yield_stress, 2.0, flow_index, delta);
                const PlugFlowLaw law{yield_stress, 2.0, flow_index};
                for (const double excess : {1e-3, 1.0, 30.0}) {
                    const double stress = yield_stress + excess;
                    const double exact = flow.speed(stress);
                    EXPECT_NEAR(bob_speed(law, stress, delta), exact, 1e-8 * exact)
                        << delta << " " << flow_index << " " << yield_stress << " " << excess;
                    EXPECT_NEAR(bob_stress(law, exact, delta), stress, 1e-7 * stress);
                }
            }
}

// physics.md section 2: R 10/20 mm, tau0 20, K 2, n 0.4, omega 0.05: bob rate 2.64326276260158 1/s,
// yield radius inside the gap. Stresses from the independent evaluation.
TEST(correction_wall_rate, published_plug_flow_is_found_from_torques_alone) {
    const IndependentGapFlow flow = herschel_bulkley_flow(20.0, 2.0, 0.4, 2.0);
    const Curve curve = curve_of(flow, 0.05 / 32.0, 0.05 * 32.0, 21);
    const WallRates found = wall_rates(curve.speeds, curve.stresses, 2.0);
    ASSERT_DOUBLE_EQ(curve.speeds[10], 0.05);
    EXPECT_NEAR(found.rows[10].rate, 2.64326276260158, 1e-6);
    EXPECT_EQ(found.rows[10].branch, GapBranch::partly_sheared);
    ASSERT_TRUE(found.yield_stress.has_value());
    EXPECT_NEAR(*found.yield_stress, 20.0, 1e-6);
}

// R 14/15 mm, tau0 5, K 0.5, n 0.5, omega 10: 183.887472870097 1/s (physics.md section 2), sheared.
TEST(correction_wall_rate, published_sheared_flow_is_found_from_torques_alone) {
    const IndependentGapFlow flow = herschel_bulkley_flow(5.0, 0.5, 0.5, 15.0 / 14.0);
    const Curve curve = curve_of(flow, 10.0 / 1024.0, 10.0 * 1024.0, 41);
    const WallRates found = wall_rates(curve.speeds, curve.stresses, 15.0 / 14.0);
    ASSERT_DOUBLE_EQ(curve.speeds[20], 10.0);
    EXPECT_NEAR(found.rows[20].rate, 183.887472870097, 1e-4);
    EXPECT_EQ(found.rows[20].branch, GapBranch::sheared);
    EXPECT_EQ(found.rows[0].branch, GapBranch::partly_sheared);
}

double largest_error(const IndependentGapFlow& flow, int count) {
    const Curve curve = curve_of(flow, 0.01, 100.0, count);
    const WallRates found = wall_rates(curve.speeds, curve.stresses, flow.delta);
    double largest = 0.0;
    for (std::size_t row = 0; row < curve.speeds.size(); ++row)
        largest = std::max(largest,
                           std::abs(found.rows[row].rate / flow.rate(curve.stresses[row]) - 1.0));
    return largest;
}

// A Carreau fluid, which no law inside the correction can follow: the largest error over four
// decades of speed is that of the slopes at the ends, third order in the spacing of the points.
TEST(correction_wall_rate, error_falls_with_the_number_of_points) {
    const IndependentGapFlow flow = carreau_flow(10.0, 0.01, 0.3, 1.0847);
    const double coarse = largest_error(flow, 20);
    const double middle = largest_error(flow, 40);
    const double fine = largest_error(flow, 80);
    EXPECT_GT(std::log2(coarse / middle), 2.4) << coarse << " " << middle << " " << fine;
    EXPECT_GT(std::log2(middle / fine), 2.4) << coarse << " " << middle << " " << fine;
    EXPECT_LT(fine, 2e-4);
}

// Casson fluid in a wide gap, again no law inside the correction: below 1 % with 40 points.
TEST(correction_wall_rate, plug_flow_of_another_law_is_found_too) {
    EXPECT_LT(largest_error(casson_flow(10.0, 0.5, 2.0), 40), 0.01);
}

struct NoisyFluid {
    const char* name;
    IndependentGapFlow flow;
};

class NoisyCurves : public ::testing::TestWithParam<NoisyFluid> {};

// 1 % of noise on every torque. A normal variable is within two standard errors with a chance of
// 0.95; the windows and the branch are chosen by the data as well, so 0.87 is asked for. The median
// standard error is bounded, so that covering by saying nothing would fail.
TEST_P(NoisyCurves, standard_error_covers_and_branches_are_right) {
    const IndependentGapFlow& flow = GetParam().flow;
    const Curve curve = curve_of(flow, 0.01, 100.0, 40);
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, 0.01);
    double covered = 0.0;
    double known = 0.0;
    double wrong_branch = 0.0;
    std::vector<double> relative_errors;
    constexpr int repeats = 16;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        std::vector<double> measured = curve.stresses;
        for (double& stress : measured)
            stress *= 1.0 + noise(random);
        const WallRates found = wall_rates(curve.speeds, measured, flow.delta);
        for (std::size_t row = 0; row < measured.size(); ++row) {
            const WallRate& rate = found.rows[row];
            const GapBranch opposite = flow.is_partly_sheared(curve.stresses[row])
                                           ? GapBranch::sheared
                                           : GapBranch::partly_sheared;
            wrong_branch += rate.branch == opposite ? 1.0 : 0.0;
            if (!std::isfinite(rate.rate))
                continue;
            const double exact = flow.rate(curve.stresses[row]);
            known += 1.0;
            covered += std::abs(rate.rate - exact) <= 2.0 * rate.standard_error ? 1.0 : 0.0;
            relative_errors.push_back(rate.standard_error / exact);
        }
    }
    const double all = static_cast<double>(repeats) * static_cast<double>(curve.speeds.size());
    EXPECT_GT(covered / known, 0.87);
    EXPECT_GT(known / all, 0.95);
    EXPECT_LT(wrong_branch / all, 0.03);
    const auto middle =
        relative_errors.begin() + static_cast<std::ptrdiff_t>(relative_errors.size() / 2);
    std::nth_element(relative_errors.begin(), middle, relative_errors.end());
    EXPECT_LT(*middle, 0.04);
}

INSTANTIATE_TEST_SUITE_P(
    correction_wall_rate, NoisyCurves,
    ::testing::Values(
        NoisyFluid{"newtonian", herschel_bulkley_flow(0.0, 0.5, 1.0, 1.0847)},
        NoisyFluid{"power_law", herschel_bulkley_flow(0.0, 2.0, 0.4, 1.0847)},
        NoisyFluid{"herschel_bulkley_narrow", herschel_bulkley_flow(5.0, 0.5, 0.5, 15.0 / 14.0)},
        NoisyFluid{"herschel_bulkley_wide", herschel_bulkley_flow(20.0, 2.0, 0.4, 2.0)},
        NoisyFluid{"bingham_wide", herschel_bulkley_flow(10.0, 0.5, 1.0, 2.0)},
        NoisyFluid{"casson_wide", casson_flow(10.0, 0.5, 2.0)},
        NoisyFluid{"carreau_narrow", carreau_flow(10.0, 0.01, 0.3, 1.0847)},
        NoisyFluid{"carreau_wide", carreau_flow(10.0, 0.01, 0.3, 2.0)}),
    [](const ::testing::TestParamInfo<NoisyFluid>& instance) { return instance.param.name; });

TEST(correction_wall_rate, order_direction_and_sense_of_turning_do_not_matter) {
    const IndependentGapFlow flow = herschel_bulkley_flow(5.0, 0.5, 0.5, 1.1);
    const Curve curve = curve_of(flow, 0.01, 100.0, 30);
    const WallRates forward = wall_rates(curve.speeds, curve.stresses, 1.1);
    std::vector<double> speeds(curve.speeds.rbegin(), curve.speeds.rend());
    std::vector<double> stresses(curve.stresses.rbegin(), curve.stresses.rend());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        speeds[i] = -speeds[i];
        stresses[i] = -stresses[i];
    }
    const WallRates backward = wall_rates(speeds, stresses, 1.1);
    for (std::size_t i = 0; i < speeds.size(); ++i)
        EXPECT_DOUBLE_EQ(backward.rows[i].rate, -forward.rows[speeds.size() - 1 - i].rate);
}

TEST(correction_wall_rate, rows_at_rest_or_driven_by_the_fluid_give_no_rate) {
    const IndependentGapFlow flow = herschel_bulkley_flow(0.0, 0.5, 1.0, 1.1);
    Curve curve = curve_of(flow, 0.01, 100.0, 20);
    curve.speeds.insert(curve.speeds.begin(), {0.0, 0.02});
    curve.stresses.insert(curve.stresses.begin(), {1.0, -1.0});
    const WallRates found = wall_rates(curve.speeds, curve.stresses, 1.1);
    EXPECT_TRUE(std::isnan(found.rows[0].rate));
    EXPECT_TRUE(std::isnan(found.rows[1].rate));
    EXPECT_EQ(found.rows[0].branch, GapBranch::unknown);
    EXPECT_NEAR(found.rows[2].rate, flow.rate(curve.stresses[2]), 1e-6 * found.rows[2].rate);
}

TEST(correction_wall_rate, one_speed_or_few_give_no_rate) {
    const std::vector<double> same(50, 1.0);
    for (const WallRate& row : wall_rates(same, same, 1.1).rows)
        EXPECT_TRUE(std::isnan(row.rate));
    const std::vector<double> four{1.0, 2.0, 3.0, 4.0};
    for (const WallRate& row : wall_rates(four, four, 1.1).rows)
        EXPECT_TRUE(std::isnan(row.rate));
    EXPECT_TRUE(wall_rates({}, {}, 1.1).rows.empty());
    EXPECT_THROW((void)wall_rates(four, four, 1.0), std::invalid_argument);
}

// Both gaps have the ratio 1.1: wall stress at both inner walls tau = M / (2 pi L (R1^2 + R3^2)),
// and the rate there is that of a single gap at the same speed.
TEST(correction_wall_rate, double_gap_of_equal_ratios_is_a_single_gap) {
    const geometry::DoubleGap twin{.radii = {0.020, 0.022, 0.024, 0.0264}, .height = 0.05};
    const IndependentGapFlow flow = herschel_bulkley_flow(0.0, 2.0, 0.5, 1.1);
    const Curve curve = curve_of(flow, 0.01, 100.0, 30);
    std::vector<double> torques;
    for (const double stress : curve.stresses)
        torques.push_back(stress * 2.0 * std::numbers::pi * twin.height *
                          (twin.radii[0] * twin.radii[0] + twin.radii[2] * twin.radii[2]));
    const RotorRates found = rotor_rates(twin, 1.0, curve.speeds, torques);
    for (std::size_t row = 0; row < torques.size(); ++row) {
        EXPECT_NEAR(found.stresses[row], curve.stresses[row], 1e-10 * curve.stresses[row]);
        EXPECT_NEAR(found.rates.rows[row].rate, flow.rate(curve.stresses[row]),
                    1e-6 * flow.rate(curve.stresses[row]));
    }
}

TEST(correction_wall_rate, double_gap_of_unequal_ratios_gives_no_rate) {
    const geometry::DoubleGap twin{.radii = {0.020, 0.022, 0.024, 0.030}, .height = 0.05};
    const std::vector<double> speeds{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    for (const WallRate& row : rotor_rates(twin, 1.0, speeds, speeds).rates.rows)
        EXPECT_TRUE(std::isnan(row.rate));
}

TEST(correction_wall_rate, box_rate_is_speed_over_gap) {
    const std::vector<double> one{0.25};
    const RotorRates found =
        rotor_rates(geometry::Box{.gap = 0.001, .length = 1.0, .width = 1.0}, 1.0, one, one);
    EXPECT_EQ(found.rates.rows[0].rate, 250.0);
    EXPECT_EQ(found.rates.rows[0].standard_error, 0.0);
}

} // namespace
} // namespace searle::rheometry
