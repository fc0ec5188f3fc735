#include "solvers/regime.hpp"

#include <gtest/gtest.h>

namespace searle::solvers {
namespace {

RegimeFacts quiet() {
    return {.speed = 1.0,
            .partly_sheared = false,
            .taylor_ratio = 0.5,
            .lag_share = 1e-6,
            .end_flow_share = 0.0,
            .accuracy = 1e-3};
}

TEST(Regime, laminar_is_the_absence_of_everything_else) {
    EXPECT_EQ(regime_name(quiet()), "laminar");
    RegimeFacts facts = quiet();
    facts.lag_share = 2e-3;
    EXPECT_EQ(regime_name(facts), "lag");
}

TEST(Regime, names_are_joined_in_a_fixed_order) {
    RegimeFacts facts = quiet();
    facts.partly_sheared = true;
    facts.lag_share = 0.5;
    facts.taylor_ratio = 1.5;
    facts.end_flow_share = 0.1;
    EXPECT_EQ(regime_name(facts), "partly-sheared+lag+taylor-vortices+end-flow");
}

TEST(Regime, a_stopped_drive_is_at_rest_even_while_the_fluid_still_moves) {
    RegimeFacts facts = quiet();
    facts.speed = 0.0;
    EXPECT_EQ(regime_name(facts), "rest");
    facts.lag_share = 1.0;
    EXPECT_EQ(regime_name(facts), "rest+lag");
}

TEST(Regime, what_is_below_the_accuracy_has_no_name) {
    RegimeFacts facts = quiet();
    facts.accuracy = 0.1;
    facts.lag_share = 0.09;
    facts.end_flow_share = 0.09;
    EXPECT_EQ(regime_name(facts), "laminar");
}

} // namespace
} // namespace searle::solvers
