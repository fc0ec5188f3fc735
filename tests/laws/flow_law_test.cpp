#include "laws/flow/flow_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace searle::laws::flow {
namespace {

/// Parameters of every law that a case file may hold; a new law gets the whole examination by a
/// line.
std::vector<AnyFlowLaw> examined_laws() {
    return {Newtonian{1.0016e-3},
            Bingham{5.0, 0.02},
            Bingham{0.0, 3.0},
            PowerLaw{2.0, 0.1},
            PowerLaw{0.5, 0.6},
            PowerLaw{1e-3, 1.8},
            HerschelBulkley{5.0, 0.5, 0.5},
            HerschelBulkley{20.0, 2.0, 0.1},
            HerschelBulkley{0.3, 1e-2, 1.7},
            HerschelBulkley{0.0, 0.5, 0.5},
            Casson{4.0, 0.05},
            Casson{0.0, 0.05},
            CarreauYasuda{10.0, 1e-3, 2.0, 0.3, 2.0},
            CarreauYasuda{1.0, 0.0, 0.05, 0.8, 0.5},
            CarreauYasuda{1.0, 0.2, 5.0, 0.1, 6.0},
            Cross{100.0, 0.01, 7.0, 0.2},
            Cross{1.0, 0.0, 0.1, 0.7}};
}

std::vector<double> rates() {
    std::vector<double> list;
    for (double rate = 1e-7; rate < 2e7; rate *= 3.1) {
        list.push_back(rate);
    }
    return list;
}

template <class Claim>
void for_every_law(const Claim& claim) {
    const std::vector<AnyFlowLaw> laws = examined_laws();
    for (std::size_t k = 0; k < laws.size(); ++k) {
        SCOPED_TRACE(std::string(name_of(laws[k])) + ", set " + std::to_string(k));
        std::visit(claim, laws[k]);
    }
}

TEST(FlowLaws, start_at_the_yield_stress_and_rise_with_the_rate) {
    for_every_law([](const auto& law) {
        EXPECT_EQ(law.stress(0.0), law.yield_stress_value());
        double before = law.stress(0.0);
        double excess_before = 0.0;
        for (const double rate : rates()) {
            EXPECT_GE(law.stress(rate), before) << rate;
            EXPECT_GT(law.excess_stress(rate), excess_before) << rate;
            before = law.stress(rate);
            excess_before = law.excess_stress(rate);
        }
    });
}

TEST(FlowLaws, split_the_stress_into_yield_and_excess) {
    for_every_law([](const auto& law) {
        for (const double rate : rates()) {
            EXPECT_DOUBLE_EQ(law.stress(rate), law.yield_stress_value() + law.excess_stress(rate));
        }
    });
}

TEST(FlowLaws, give_the_rate_back_from_the_excess_stress) {
    for_every_law([](const auto& law) {
        EXPECT_EQ(law.rate_at_excess(0.0), 0.0);
        for (const double rate : rates()) {
            // The inverse cannot be better than the excess is conditioned: d ln rate / d ln excess.
            const double condition = law.excess_stress(rate) / (rate * law.stress_slope(rate));
            EXPECT_NEAR(law.rate_at_excess(law.excess_stress(rate)) / rate, 1.0,
                        1e-14 * (4.0 + 30.0 * condition))
                << rate;
        }
    });
}

TEST(FlowLaws, slopes_are_the_derivatives_of_the_stress) {
    for_every_law([](const auto& law) {
        for (const double rate : rates()) {
            // Central difference in ln(rate), fourth order: error ~ h^4 + rounding / h.
            const double h = 2e-3;
            const auto excess = [&](double s) {
                return double{law.excess_stress(rate * std::exp(s))};
            };
            const double derivative =
                (8.0 * (excess(h) - excess(-h)) - (excess(2 * h) - excess(-2 * h))) / (12.0 * h);
            EXPECT_NEAR(law.stress_slope(rate) * rate / derivative, 1.0, 1e-8) << rate;
            EXPECT_NEAR(law.log_slope(rate) * law.stress(rate) / derivative, 1.0, 1e-8) << rate;
        }
    });
}

TEST(FlowLaws, inverse_through_the_variant_is_zero_up_to_the_yield_stress) {
    for (const AnyFlowLaw& law : examined_laws()) {
        EXPECT_EQ(rate(law, 0.0), 0.0);
        EXPECT_EQ(rate(law, yield_stress(law)), 0.0);
        EXPECT_EQ(rate(law, 0.5 * yield_stress(law)), 0.0);
        EXPECT_GT(rate(law, 1.001 * yield_stress(law) + 1e-9), 0.0);
    }
}

TEST(FlowLaws, special_cases_coincide) {
    for (const double rate : rates()) {
        EXPECT_DOUBLE_EQ((HerschelBulkley{5, 0.3, 1}.stress(rate)), (Bingham{5, 0.3}.stress(rate)));
        EXPECT_DOUBLE_EQ((HerschelBulkley{0, 0.3, 0.7}.stress(rate)),
                         (PowerLaw{0.3, 0.7}.stress(rate)));
        EXPECT_DOUBLE_EQ((Bingham{0, 0.3}.stress(rate)), (Newtonian{0.3}.stress(rate)));
        EXPECT_DOUBLE_EQ((Casson{0, 0.3}.stress(rate)), (Newtonian{0.3}.stress(rate)));
        EXPECT_NEAR((CarreauYasuda{0.3, 0.1, 5, 1, 2}.stress(rate)) / (0.3 * rate), 1.0, 1e-14);
    }
}

// Values worked out by hand from the laws as published.
TEST(FlowLaws, hold_published_forms_at_points_that_can_be_checked_by_hand) {
    EXPECT_DOUBLE_EQ((HerschelBulkley{5, 0.5, 0.5}.stress(100.0)), 10.0);
    // sqrt(tau) = sqrt(4) + sqrt(0.09 * 100) = 5.
    EXPECT_DOUBLE_EQ((Casson{4, 0.09}.stress(100.0)), 25.0);
    // Carreau at lambda rate = 1 with a = 2: [1 + 1]^((n-1)/2).
    EXPECT_NEAR((CarreauYasuda{10, 0, 0.5, 0.4, 2}.viscosity(2.0)), 10 * std::pow(2.0, -0.3),
                1e-14);
    // Cross at lambda rate = 1: half way between the plateaus.
    EXPECT_DOUBLE_EQ((Cross{10, 2, 0.5, 0.4}.viscosity(2.0)), 6.0);
}

TEST(FlowLaws, log_slope_stays_finite_where_the_stress_is_all_yield) {
    const HerschelBulkley law{1e9, 1e-6, 2.0};
    EXPECT_GE(law.log_slope(1e-150), 0.0);
    EXPECT_TRUE(std::isfinite(law.log_slope(1e-150)));
}

} // namespace
} // namespace searle::laws::flow
