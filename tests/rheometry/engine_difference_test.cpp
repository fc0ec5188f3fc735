#include "rheometry/report/engine_difference.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace searle::rheometry::report {
namespace {

OverlayRun run_of(const std::string& name, const std::string& gap, const std::string& engine,
                  double stress, double error) {
    OverlayRun run;
    run.name = name;
    run.swept_values = {gap, engine};
    for (const double rate : {10.0, 100.0}) {
        RheogramPoint point;
        point.shear_rate = rate;
        point.shear_stress = rate * stress;
        point.stress_error = rate * error;
        run.rheogram.points.push_back(point);
    }
    return run;
}

OverlayInput two_gaps_by_two_engines() {
    OverlayInput input;
    input.swept_keys = {"geometry.gap", "solver.engine"};
    input.runs = {run_of("wide-native", "1 mm", "native", 1.0, 0.001),
                  run_of("wide-openfoam", "1 mm", "openfoam", 1.02, 0.002),
                  run_of("narrow-native", "0.5 mm", "native", 4.0, 0.01),
                  run_of("narrow-openfoam", "0.5 mm", "openfoam", 3.96, 0.03)};
    return input;
}

bool holds(const Figure& figure, const std::string& text) {
    return figure.panels.at(0).find(text) != std::string::npos;
}

TEST(EngineDifference, is_taken_from_the_run_that_differs_in_the_engine_alone) {
    const auto figure = engine_difference_figure(two_gaps_by_two_engines());
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->panels.size(), 1u);
    EXPECT_TRUE(holds(*figure, "wide-openfoam"));
    EXPECT_TRUE(holds(*figure, "2 % \u00b1 0.3 %"));
    EXPECT_TRUE(holds(*figure, "narrow-openfoam"));
    EXPECT_TRUE(holds(*figure, "\u22121 % \u00b1 1 %"));
    EXPECT_FALSE(holds(*figure, "native"));
}

TEST(EngineDifference, of_one_engine_there_is_none) {
    OverlayInput input = two_gaps_by_two_engines();
    input.runs = {input.runs[0], input.runs[2]};
    EXPECT_FALSE(engine_difference_figure(input)); // each is its own reference
    input.swept_keys = {"geometry.gap"};
    EXPECT_FALSE(engine_difference_figure(input));
}

TEST(EngineDifference, rows_of_an_engine_that_broke_off_are_compared_as_far_as_they_go) {
    OverlayInput input = two_gaps_by_two_engines();
    input.runs[1].rheogram.points.resize(1);
    input.runs[3].rheogram.points.clear();
    const auto figure = engine_difference_figure(input);
    ASSERT_TRUE(figure);
    EXPECT_TRUE(holds(*figure, "wide-openfoam"));
    EXPECT_FALSE(holds(*figure, "narrow-openfoam"));
}

} // namespace
} // namespace searle::rheometry::report
