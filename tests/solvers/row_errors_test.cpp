#include "solvers/row_errors.hpp"
#include "solvers/steps_of_level.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers {
namespace {

/// Up for 2 s and down for 2 s, a row a second; then a jump up for a second.
rheometry::SpeedHistory up_down_and_jump() {
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 2.0, 0.0, 1.0}, {2.0, 4.0, 1.0, 0.0}, {4.0, 5.0, 3.0, 3.0}};
    history.row_times = {1.0, 2.0, 3.0, 4.0, 5.0};
    return history;
}

TEST(LevelChanges, a_row_counts_what_its_neighbour_changed_by_relative_to_the_larger_of_both) {
    const std::vector<double> before{1.0, 2.0, 1.0, 0.1, 3.0};
    const std::vector<double> after{1.0, 2.1, 1.0, 0.1, 3.0};
    const std::vector<double> change = level_changes(before, after, up_down_and_jump(), 0.0);
    EXPECT_DOUBLE_EQ(change[1], 2.1 - 2.0);
    // In one piece, or from the row that a piece begins at, the change itself.
    EXPECT_DOUBLE_EQ(change[0], 2.1 - 2.0);
    EXPECT_DOUBLE_EQ(change[2], 2.1 - 2.0);
    EXPECT_EQ(change[3], 0.0);
    EXPECT_EQ(change[4], 0.0);
}

TEST(LevelChanges, a_small_torque_that_changed_says_little_of_large_ones) {
    const std::vector<double> before{1.0, 2.0, 1.0, 0.1, 3.0};
    const std::vector<double> after{1.0, 2.0, 1.0, 0.2, 3.0};
    const std::vector<double> change = level_changes(before, after, up_down_and_jump(), 0.0);
    EXPECT_NEAR(change[3], 0.1, 1e-15);
    EXPECT_NEAR(change[2], 0.1, 1e-15);
    // Beyond a jump it is the same share of the larger one, which is as much.
    EXPECT_NEAR(change[4], 0.1, 1e-15);
    EXPECT_EQ(change[1], 0.0);
}

TEST(LevelChanges, beyond_a_jump_a_larger_neighbour_counts_by_its_share) {
    const std::vector<double> before{1.0, 2.0, 1.0, 0.1, 3.0};
    const std::vector<double> after{1.0, 2.0, 1.0, 0.1, 3.3};
    const std::vector<double> change = level_changes(before, after, up_down_and_jump(), 0.0);
    EXPECT_NEAR(change[3], 0.3 / 3.3 * 0.1, 1e-15);
    EXPECT_EQ(change[2], 0.0);
}

TEST(LevelChanges, steps_may_err_by_their_tolerance_of_a_neighbour_in_the_same_piece) {
    const std::vector<double> same{1.0, 2.0, 1.0, 0.1, 3.0};
    const std::vector<double> change = level_changes(same, same, up_down_and_jump(), 1e-2);
    EXPECT_DOUBLE_EQ(change[2], 2e-2);
    EXPECT_DOUBLE_EQ(change[3], 1e-2);
    EXPECT_DOUBLE_EQ(change[4], 3e-2);
}

TEST(TurnsWithinAPiece, is_told_from_turning_at_a_jump) {
    const auto turns = [](const std::vector<double>& torque) {
        return turns_within_a_piece(torque, up_down_and_jump());
    };
    EXPECT_TRUE(turns({1.0, 2.0, -0.1, -0.2, 3.0}));
    EXPECT_TRUE(turns({1.0, 2.0, 1.0, -0.2, -3.0}));
    EXPECT_FALSE(turns({1.0, 2.0, 1.0, 0.1, -3.0}));
    EXPECT_FALSE(turns({1.0, 2.0, 1.0, 0.0, -3.0}));
    EXPECT_FALSE(turns({}));
}

TEST(LevelErrors, two_levels_claim_three_times_their_difference_and_three_what_they_tell) {
    const std::vector<double> change{1.0, 1.0, 1.0};
    EXPECT_EQ(level_errors(change, {}), (std::vector{3.0, 3.0, 3.0}));
    // The last change fell to a tenth, to a half, and not at all.
    EXPECT_EQ(level_errors(change, std::vector{10.0, 2.0, 0.5}), (std::vector{1.0, 2.0, 2.0}));
}

TEST(StepsOfLevel, the_next_level_takes_a_share_of_the_step_it_is_in) {
    StepsOfLevel steps;
    EXPECT_TRUE(std::isinf(steps.longest_from(0.0)));
    steps.add(1.0);
    steps.add(3.0);
    EXPECT_DOUBLE_EQ(steps.longest_from(0.0), StepsOfLevel::share);
    EXPECT_DOUBLE_EQ(steps.longest_from(0.9), StepsOfLevel::share);
    EXPECT_DOUBLE_EQ(steps.longest_from(1.0), 2.0 * StepsOfLevel::share);
    EXPECT_TRUE(std::isinf(steps.longest_from(3.0)));
}

} // namespace
} // namespace searle::solvers
