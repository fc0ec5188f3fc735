#include "tests/app/case_texts.hpp"

#include "places.hpp"
#include <fstream>

#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

using namespace searle;
using namespace searle::app;

namespace {

std::vector<Case> cases(const std::string& sweep, const std::vector<std::string>& overrides = {}) {
    return read_cases_text(also(sweep), "case.toml", overrides);
}

double cup(const Case& one) {
    return std::get<geometry::ConcentricCylinders>(one.scene.instrument).cup_radius;
}

} // namespace

TEST(case_sweep, varied_values_are_combined_first_key_slowest) {
    const auto all = cases("[sweep]\nvary = { \"geometry.cup_radius\" = [\"14.5 mm\", \"15 mm\"], "
                           "\"protocol.to\" = [\"100 1/s\", \"3 rpm\", \"50 1/s\"] }\n");
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[0].name, "cup_radius=14.5mm,to=100_per_s");
    EXPECT_EQ(all[1].name, "cup_radius=14.5mm,to=3rpm");
    EXPECT_EQ(all[5].name, "cup_radius=15mm,to=50_per_s");
    EXPECT_EQ(cup(all[0]), 0.0145);
    EXPECT_EQ(cup(all[3]), 0.015);
}

TEST(case_sweep, dotted_keys_need_no_quotes) {
    const auto all = cases("[sweep]\nvary.geometry.cup_radius = [\"14.5 mm\", \"15 mm\"]\n");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(cup(all[0]), 0.0145);
}

TEST(case_sweep, runs_set_keys_and_replace_sections) {
    const auto all = cases(R"([[sweep.runs]]
name = "as-given"
[[sweep.runs]]
name = "thick"
set = { fluid = { viscosity = "1 Pa.s" }, "solver.accuracy" = "1 %", conversion.end_factor = 1.2 }
[[sweep.runs]]
name = "steps"
set = { protocol = { type = "steps", shear_rates = ["1 1/s"] } }
)");
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].name, "as-given");
    EXPECT_EQ(std::get<laws::flow::Newtonian>(all[1].scene.fluid.law).viscosity, 1.0);
    EXPECT_EQ(all[1].scene.fluid.density, 998.2) << "merged key by key";
    EXPECT_EQ(all[1].scene.solver.accuracy, 0.01);
    EXPECT_EQ(all[1].scene.conversion.end_factor, 1.2);
    EXPECT_TRUE(std::holds_alternative<rheometry::Steps>(all[2].scene.protocol.program))
        << "a section with its type is replaced whole";
}

TEST(case_sweep, runs_are_combined_with_varied_values) {
    const auto all =
        cases("[sweep]\nvary = { \"geometry.cup_radius\" = [\"14.5 mm\", \"15 mm\"] }\n"
              "[[sweep.runs]]\nname = \"a\"\n[[sweep.runs]]\nname = \"b\"\n");
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[0].name, "a,cup_radius=14.5mm");
    EXPECT_EQ(all[3].name, "b,cup_radius=15mm");
}

TEST(case_sweep, only_the_keys_that_choose_replace_a_section) {
    const auto all = cases("[solver]\naccuracy = \"1 %\"\n[[sweep.runs]]\nname = \"a\"\n"
                           "set = { solver = { model = \"radial\" } }\n");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].scene.solver.model, solvers::Model::radial);
    EXPECT_EQ(all[0].scene.solver.accuracy, 0.01)
        << "[solver] is merged, its model chooses no keys";
}

TEST(case_sweep, example_of_the_reference_page_is_valid) {
    std::ifstream file{std::string{SEARLE_SOURCE_DIR} + "/docs/case-file.md"};
    const std::string page{std::istreambuf_iterator<char>{file}, {}};
    const std::size_t start = page.find("```toml\n");
    ASSERT_NE(start, std::string::npos);
    const std::string example = page.substr(start + 8, page.find("```", start + 8) - start - 8);
    EXPECT_EQ(cases(example).size(), 4U);
}

TEST(case_sweep, resolved_case_stands_alone) {
    const auto all =
        cases("[sweep]\nvary = { \"geometry.cup_radius\" = [\"14.5 mm\", \"15 mm\"] }\n");
    EXPECT_EQ(all[0].resolved_toml.find("sweep"), std::string::npos);
    EXPECT_NE(all[0].hash, all[1].hash);
    EXPECT_EQ(read_text(all[0].resolved_toml).hash, all[0].hash);
    EXPECT_EQ(all[0].lines.at("geometry.cup_radius"), 18) << "the line in the sweep";
}

TEST(case_sweep, faults_point_into_the_sweep) {
    const std::string sweep = "[sweep]\nvary = { \"geometry.cup_radius\" = [\"15 mm\", \"13 mm\", "
                              "\"16\"], \"protocol.ponts\" = [3] }\n";
    const auto faults = faults_of(also(sweep));
    ASSERT_EQ(faults.size(), 3U) << "each once, not once a case";
    for (const auto& fault : faults)
        EXPECT_EQ(fault.places.front().line, 18) << fault.text();
    EXPECT_EQ(faults[0].problem, "the cup must be wider than the bob");
    EXPECT_EQ(faults[1].problem, "\"16\" has no unit");
    EXPECT_EQ(faults[2].suggestion, "points");
}

TEST(case_sweep, faults_of_the_sweep_itself) {
    EXPECT_EQ(only_fault(also("[sweep]\n")).problem, "the sweep names no case");
    EXPECT_EQ(only_fault(also("[sweep]\nvery = 3\n")).suggestion, "vary");
    EXPECT_NE(
        only_fault(also("[sweep]\nvary = { \"protocol.points\" = 3 }\n")).problem.find("no list"),
        std::string::npos);
    EXPECT_NE(
        only_fault(also("[sweep]\nvary = { \"protocol.points\" = [] }\n")).problem.find("no list"),
        std::string::npos);
    EXPECT_NE(only_fault(also("[sweep]\nvary = { \"protocol.points\" = [3, 3] }\n"))
                  .problem.find("two cases"),
              std::string::npos);
    EXPECT_NE(only_fault(also("[[sweep.runs]]\nname = \"a/b\"\n")).problem.find("folder"),
              std::string::npos);
    EXPECT_NE(only_fault(also("[[sweep.runs]]\nname = \"..\"\n")).problem.find("folder"),
              std::string::npos);
    EXPECT_EQ(only_fault(also("[[sweep.runs]]\nset = {}\n")).key, "sweep.runs.1.name");
    EXPECT_EQ(only_fault(also("[[sweep.runs]]\nname = \"a\"\nset = 3\n")).key, "sweep.runs.1.set");
    std::string many;
    for (int value = 1; value <= 1000; ++value)
        many += std::to_string(value) + ", ";
    EXPECT_EQ(only_fault(also("[sweep]\nvary = { \"protocol.points\" = [" + many +
                              "], \"solver.accuracy\" = [" + many + "] }\n"))
                  .problem,
              "the sweep has too many cases");
}

TEST(case_sweep, overrides_apply_to_every_case_but_not_to_swept_keys) {
    const std::string sweep =
        "[sweep]\nvary = { \"geometry.cup_radius\" = [\"14.5 mm\", \"15 mm\"] }\n";
    for (const Case& one : cases(sweep, {"protocol.points=7"}))
        EXPECT_EQ(std::get<rheometry::Ramp>(one.scene.protocol.program).points, 7);
    const auto fault = only_fault(also(sweep), {"geometry.cup_radius=16 mm"});
    EXPECT_EQ(fault.problem, "is set by the sweep too");
    EXPECT_EQ(fault.places.size(), 2U);
    EXPECT_EQ(only_fault(also(sweep), {"geometry={type=\"box\"}"}).problem,
              "is set by the sweep too");
}
