#include "laws/flow/flow_law.hpp"

#include "laws/flow/ellis.hpp"
#include "laws/flow/sisko.hpp"
#include "laws/flow/windhab.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace searle::laws::flow {
namespace {

/// The laws that a case file may hold, and those that data are fitted with only.
using ExaminedLaw = std::variant<Newtonian, Bingham, PowerLaw, HerschelBulkley, Casson,
                                 CarreauYasuda, Cross, Sisko, Ellis, Windhab>;

/// Parameters of every law; a new law gets the whole examination by a line.
std::vector<ExaminedLaw> examined_laws() {
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
            Cross{1.0, 0.0, 0.1, 0.7},
            Sisko{0.08, 3.0, 0.3},
            Sisko{0.0, 0.5, 0.6},
            Sisko{1e-3, 2.0, 1.4},
            Ellis{12.0, 9.0, 2.4},
            Ellis{0.5, 100.0, 1.0},
            Ellis{1e3, 0.2, 5.0},
            Windhab{3.0, 9.0, 0.05, 12.0},
            Windhab{0.0, 20.0, 1e-3, 0.5},
            Windhab{4.0, 4.0, 0.1, 1.0}};
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
    const std::vector<ExaminedLaw> laws = examined_laws();
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const std::string_view name = std::visit([](const auto& law) { return law.name; }, laws[k]);
        SCOPED_TRACE(std::string(name) + ", set " + std::to_string(k));
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
    for_every_law([](const auto& chosen) {
        if constexpr (std::is_constructible_v<AnyFlowLaw, decltype(chosen)>) {
            const AnyFlowLaw law{chosen};
            EXPECT_EQ(rate(law, 0.0), 0.0);
            EXPECT_EQ(rate(law, yield_stress(law)), 0.0);
            EXPECT_EQ(rate(law, 0.5 * yield_stress(law)), 0.0);
            EXPECT_GT(rate(law, 1.001 * yield_stress(law) + 1e-9), 0.0);
        }
    });
}

TEST(FlowLaws, special_cases_coincide) {
    for (const double rate : rates()) {
        EXPECT_DOUBLE_EQ((HerschelBulkley{5, 0.3, 1}.stress(rate)), (Bingham{5, 0.3}.stress(rate)));
        EXPECT_DOUBLE_EQ((HerschelBulkley{0, 0.3, 0.7}.stress(rate)),
                         (PowerLaw{0.3, 0.7}.stress(rate)));
        EXPECT_DOUBLE_EQ((Bingham{0, 0.3}.stress(rate)), (Newtonian{0.3}.stress(rate)));
        EXPECT_DOUBLE_EQ((Casson{0, 0.3}.stress(rate)), (Newtonian{0.3}.stress(rate)));
        EXPECT_NEAR((CarreauYasuda{0.3, 0.1, 5, 1, 2}.stress(rate)) / (0.3 * rate), 1.0, 1e-14);
        EXPECT_DOUBLE_EQ((Sisko{0, 0.3, 0.7}.stress(rate)), (PowerLaw{0.3, 0.7}.stress(rate)));
        EXPECT_NEAR((Ellis{0.6, 5, 1}.stress(rate)) / (0.3 * rate), 1.0, 1e-14);
        EXPECT_DOUBLE_EQ((Windhab{5, 5, 0.3, 2}.stress(rate)), (Bingham{5, 0.3}.stress(rate)));
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
    EXPECT_DOUBLE_EQ((Sisko{0.1, 3, 0.5}.stress(4.0)), 0.4 + 6.0);
    // Ellis: at half_stress the viscosity is half of zero_viscosity, so the rate is 2 * 9 / 12.
    EXPECT_NEAR((Ellis{12, 9, 2.4}.stress(1.5)), 9.0, 1e-14);
    // Windhab at the characteristic rate: 1 - 1/e of the way to the straight line.
    EXPECT_NEAR((Windhab{3, 9, 0.05, 12}.stress(12.0)), 3.0 + 6.0 * (1.0 - std::exp(-1.0)) + 0.6,
                1e-14);
}

TEST(FlowLaws, log_slope_stays_finite_where_the_stress_is_all_yield) {
    const HerschelBulkley law{1e9, 1e-6, 2.0};
    EXPECT_GE(law.log_slope(1e-150), 0.0);
    EXPECT_TRUE(std::isfinite(law.log_slope(1e-150)));
}

} // namespace
} // namespace searle::laws::flow
