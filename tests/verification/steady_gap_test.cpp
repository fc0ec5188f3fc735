#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "verification/precise_gap_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace searle::solvers::radial {
namespace {

using namespace laws::flow;

// Expected numbers: an independent evaluation, recorded as checked values with the physics of this
// program (Herschel-Bulkley in a gap, two scenes, 15 digits).
TEST(SteadyGap, herschel_bulkley_matches_the_checked_values) {
    const SteadyGapFlow narrow =
        steady_gap_flow({0.014, 0.015}, HerschelBulkley{5.0, 0.5, 0.5}, 10.0);
    EXPECT_NEAR(narrow.inner_wall_stress, 11.7802557634299, 2e-13);
    EXPECT_NEAR(narrow.inner_wall_rate, 183.887472870097, 1e-11);
    EXPECT_NEAR(narrow.torque_per_length, 0.0145074358658097, 1e-15);
    EXPECT_FALSE(narrow.partly_sheared);

    const SteadyGapFlow wide =
        steady_gap_flow({0.010, 0.020}, HerschelBulkley{20.0, 2.0, 0.4}, 0.05);
    EXPECT_NEAR(wide.inner_wall_stress, 22.9504355400752, 2e-13);
    EXPECT_NEAR(wide.inner_wall_rate, 2.64326276260158, 1e-12);
    EXPECT_NEAR(wide.yield_radius, 10.7122442886809e-3, 1e-15);
    EXPECT_TRUE(wide.partly_sheared);
}

// Bob stresses at 14/15 mm, from the table of measured peers: 0.1 ... 1000 1/s at the bob wall
// (Newtonian factor), six digits.
TEST(SteadyGap, herschel_bulkley_slurry_matches_the_tabled_bob_stresses) {
    const double delta = 15.0 / 14.0;
    const double factor = 2.0 * delta * delta / (delta * delta - 1.0);
    const double expected[][2] = {
        {0.1, 5.37087}, {1, 5.81550}, {10, 6.96519}, {100, 10.50938}, {1000, 21.68992}};
    for (const auto& [rate, stress] : expected) {
        const auto flow =
            steady_gap_flow({0.014, 0.015}, HerschelBulkley{5.0, 0.5, 0.5}, rate / factor);
        EXPECT_NEAR(flow.inner_wall_stress, stress, 6e-6) << rate;
    }
}

TEST(SteadyGap, newtonian_torque_matches_the_closed_form) {
    for (const double delta : {1.0001, 1.001, 1.0847, 2.0, 20.0}) {
        const AnnularGap gap{0.014, 0.014 * delta};
        const double omega = 3.0;
        // M/L = 4 pi eta omega a^2 b^2 / (b^2 - a^2); Couette 1890.
        const double exact = 4.0 * std::numbers::pi * 0.7 * omega * gap.outer_radius *
                             gap.outer_radius / gap.ratio_squared_minus_one();
        EXPECT_NEAR(steady_gap_flow(gap, Newtonian{0.7}, omega).torque_per_length / exact, 1.0,
                    2e-13 + 1e-16 / (delta - 1.0))
            << delta;
    }
}

TEST(SteadyGap, power_law_rate_matches_the_closed_form) {
    for (const double n : {0.1, 0.3, 1.0, 1.7}) {
        for (const double delta : {1.001, 1.5, 20.0}) {
            const auto flow = steady_gap_flow({0.01, 0.01 * delta}, PowerLaw{2.0, n}, 0.3);
            // rate = 2 omega / (n (1 - delta^(-2/n))), from omega = n/2 rate (1 - delta^(-2/n)).
            const double exact = 2.0 * 0.3 / (n * -std::expm1(-2.0 / n * std::log(delta)));
            EXPECT_NEAR(flow.inner_wall_rate / exact, 1.0, 1e-11) << n << ' ' << delta;
        }
    }
}

TEST(SteadyGap, bingham_sheared_throughout_matches_reiner_and_riwlin) {
    // omega = (tau_b / 2 mu)(1 - 1/delta^2) - (tau0 / mu) ln(delta); Reiner & Riwlin 1927.
    const double delta = 1.2;
    const double omega = 40.0;
    const Bingham law{3.0, 0.2};
    const auto flow = steady_gap_flow({0.01, 0.012}, law, omega);
    const double exact = 2.0 * law.plastic_viscosity *
                         (omega + law.yield_stress / law.plastic_viscosity * std::log(delta)) /
                         (1.0 - 1.0 / (delta * delta));
    ASSERT_FALSE(flow.partly_sheared);
    EXPECT_NEAR(flow.inner_wall_stress / exact, 1.0, 1e-13);
}

TEST(SteadyGap, every_law_is_right_to_1e_minus_11_against_50_digits) {
    std::mt19937_64 engine(7);
    const auto log_uniform = [&](double low, double high) {
        return std::exp(
            std::uniform_real_distribution<double>(std::log(low), std::log(high))(engine));
    };
    for (int k = 0; k < 20; ++k) {
        const double omega = log_uniform(1e-6, 1e3);
        const double shrink = log_uniform(2e-3, 100.0);
        const double radius = 0.01;
        const AnnularGap gap{radius, radius * std::sqrt(1.0 + shrink)};
        const double n = log_uniform(0.15, 1.9);
        const double yield = log_uniform(1e-3, 1e4) * std::pow(omega, n);
        for (const AnyFlowLaw& law :
             {AnyFlowLaw{Newtonian{0.3}}, AnyFlowLaw{Bingham{yield, 1.0}},
              AnyFlowLaw{PowerLaw{1.0, n}}, AnyFlowLaw{HerschelBulkley{yield, 1.0, n}},
              AnyFlowLaw{Casson{yield, 1.0}},
              AnyFlowLaw{CarreauYasuda{1.0, 1e-3, 3.0 / omega, 0.4, 4.0}},
              AnyFlowLaw{Cross{1.0, 1e-3, 3.0 / omega, 0.4}}}) {
            const auto flow = steady_gap_flow(gap, law, omega);
            EXPECT_LT(std::abs(verification::steady_stress_error(law, gap.ratio_squared_minus_one(),
                                                                 omega, flow.inner_wall_stress)),
                      flow.relative_error)
                << name_of(law) << " omega " << omega << " ratio " << shrink << " n " << n;
        }
    }
}

TEST(SteadyInstrument, double_gap_is_the_sum_of_both_annuli) {
    // 4 pi eta omega L [R1^2 R2^2/(R2^2-R1^2) + R3^2 R4^2/(R4^2-R3^2)].
    const geometry::DoubleGap gaps{{0.020, 0.02038, 0.02196, 0.02238}, 0.055};
    const auto annulus = [](double a, double b) { return a * a * b * b / ((b - a) * (b + a)); };
    const double exact = 4.0 * std::numbers::pi * 1e-3 * 2.0 * 0.055 *
                         (annulus(0.020, 0.02038) + annulus(0.02196, 0.02238));
    EXPECT_NEAR(steady_instrument_flow(gaps, Newtonian{1e-3}, 2.0).torque / exact, 1.0, 1e-12);
}

TEST(SteadyInstrument, box_force_is_stress_times_area_and_odd_in_the_speed) {
    const geometry::Box box{50e-6, 1e-3, 2e-3};
    const HerschelBulkley law{5.0, 0.5, 0.5};
    const double force = steady_instrument_flow(box, law, 9e-3).torque; // 180 1/s
    EXPECT_DOUBLE_EQ(force, law.stress(180.0) * 2e-6);
    EXPECT_EQ(steady_instrument_flow(box, law, -9e-3).torque, -force);
    EXPECT_EQ(steady_instrument_flow(box, law, 0.0).torque, 0.0);
}

} // namespace
} // namespace searle::solvers::radial
