#include "app/solved_case.hpp"

#include <gtest/gtest.h>

namespace {

using namespace searle::app;

SolvedCase solved_with(bool reached, bool interrupted) {
    SolvedCase solved{};
    solved.plan.rows.resize(4);
    solved.plan.warnings = {"of the plan"};
    solved.rheogram.points.resize(interrupted ? 2 : 4);
    solved.solution.reached = reached;
    solved.solution.interrupted = interrupted;
    solved.solution.worst_relative_error = 0.02;
    solved.solution.notes = {"of the solver"};
    return solved;
}

TEST(SolvedCase, complete_results_carry_only_the_warnings_of_plan_and_solver) {
    const SolvedCase solved = solved_with(true, false);
    EXPECT_EQ(completeness_of(solved), Completeness::complete);
    EXPECT_EQ(warnings_of(solved), (std::vector<std::string>{"of the plan", "of the solver"}));
}

TEST(SolvedCase, accuracy_that_was_not_reached_is_said_with_both_numbers) {
    const SolvedCase solved = solved_with(false, false);
    EXPECT_EQ(completeness_of(solved), Completeness::not_reached);
    EXPECT_EQ(warnings_of(solved).back(),
              "The asked accuracy of 0.1 % was not reached: the largest estimated error is 2 %.");
}

TEST(SolvedCase, an_interrupt_comes_before_an_accuracy_that_was_not_reached) {
    const SolvedCase solved = solved_with(false, true);
    EXPECT_EQ(completeness_of(solved), Completeness::interrupted);
    EXPECT_EQ(warnings_of(solved).back(), "Interrupted: 2 of 4 points were finished.");
}

TEST(SolvedCase, an_interrupt_after_the_last_point_does_not_pass_for_a_whole_run) {
    SolvedCase solved = solved_with(false, true);
    solved.rheogram.points.resize(solved.plan.rows.size());
    EXPECT_EQ(warnings_of(solved).back(),
              "Interrupted: every point is there, but not with the asked accuracy of 0.1 %; the "
              "largest estimated error is 2 %.");
}

} // namespace
