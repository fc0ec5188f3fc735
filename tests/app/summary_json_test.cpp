#include "app/summary_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace searle::app;

RunSummary full_summary() {
    RunSummary summary;
    summary.title = "Wasser \"1 mm\" \n\u03b7";
    summary.origin = {.file = "a.toml",
                      .name = "a",
                      .hash = "0123456789abcdef",
                      .lines = {{"geometry.bob_radius", 7}},
                      .written = {{"geometry.bob_radius", "14 mm"}}};
    summary.created = "2024-05-17T09:30:00Z";
    summary.versions = {{"searle", "0.1.0"}};
    summary.completeness = Completeness::not_reached;
    summary.rows = 3;
    summary.rows_asked = 4;
    summary.transient = true;
    summary.solver = {.engine = "native",
                      .model = "radial transient",
                      .model_asked = "auto",
                      .model_reason = "because",
                      .accuracy_asked = 1e-3,
                      .worst_relative_error = 0.1 + 0.2,
                      .largest_stress_error = std::numeric_limits<double>::denorm_min(),
                      .worst_torque_imbalance = std::nan(""),
                      .refinements = 2,
                      .elements = 16,
                      .time_steps = 1L << 40,
                      .linear_solves = 5,
                      .unknowns = 6};
    summary.conversion = {.definition = "bob-wall",
                          .stress_per_torque = 1.0 / 3.0,
                          .rate_per_speed = 15.5,
                          .end_factor = 1.1};
    summary.taylor = TaylorNumbers{185.0, 100.0, 3.13, 17.5, "the viscosity"};
    summary.regimes = {{"laminar", 2}, {"laminar+lag", 1}};
    summary.plan = {{"inertia", true, "Large."}};
    summary.warnings = {"careful"};
    summary.timings = {{"solve", 0.25, 0.125}};
    summary.files = {"rheogram.csv", "summary.json"};
    return summary;
}

TEST(SummaryJson, a_run_comes_back_bit_for_bit) {
    const std::string text = summary_json(full_summary());
    const RunSummary back = read_run_summary(text);
    EXPECT_EQ(summary_json(back), text);
    EXPECT_EQ(back.title, full_summary().title);
    EXPECT_EQ(back.solver.worst_relative_error, 0.1 + 0.2);
    EXPECT_EQ(back.solver.largest_stress_error, std::numeric_limits<double>::denorm_min());
    EXPECT_TRUE(std::isnan(back.solver.worst_torque_imbalance));
    EXPECT_EQ(back.solver.time_steps, 1L << 40);
    EXPECT_EQ(back.conversion.stress_per_torque, 1.0 / 3.0);
    EXPECT_EQ(back.completeness, Completeness::not_reached);
    EXPECT_EQ(back.taylor->critical_reynolds, 185.0);
    EXPECT_EQ(back.taylor->onset_shear_rate, 17.5);
    EXPECT_EQ(back.origin.lines.at("geometry.bob_radius"), 7);
    EXPECT_EQ(back.plan.at(0).reason, "Large.");
}

TEST(SummaryJson, a_sweep_comes_back) {
    SweepSummary summary;
    summary.title = "figure";
    summary.case_file = "figure.toml";
    summary.completeness = Completeness::interrupted;
    summary.runs_asked = 2;
    summary.swept_keys = {"geometry.cup_radius"};
    summary.runs = {{.name = "gap-1",
                     .swept_values = {"15 mm"},
                     .completeness = Completeness::interrupted,
                     .rows = 7,
                     .wall_seconds = 0.5}};
    summary.files = {"summary.json"};
    const std::string text = summary_json(summary);
    EXPECT_EQ(kind_of_summary(text), SummaryKind::sweep);
    EXPECT_EQ(summary_json(read_sweep_summary(text)), text);
    EXPECT_EQ(read_sweep_summary(text).runs.at(0).swept_values.at(0), "15 mm");
}

TEST(SummaryJson, interrupted_is_a_key_of_its_own_for_scripts) {
    RunSummary summary = full_summary();
    EXPECT_NE(summary_json(summary).find("\"interrupted\": false"), std::string::npos);
    summary.completeness = Completeness::interrupted;
    EXPECT_NE(summary_json(summary).find("\"interrupted\": true"), std::string::npos);
}

TEST(SummaryJson, text_of_another_kind_is_told_apart) {
    EXPECT_EQ(kind_of_summary(summary_json(full_summary())), SummaryKind::run);
    for (const char* text : {"", "{", "[]", "3", "{}", R"({"program": "other", "files": []})",
                             R"({"program": "searle"})", "\xff\xfe"}) {
        EXPECT_EQ(kind_of_summary(text), SummaryKind::none) << text;
        EXPECT_TRUE(files_listed(text).empty()) << text;
        EXPECT_THROW((void)read_run_summary(text), std::runtime_error) << text;
    }
    // The right kind with a key missing or of the wrong type is an error that says so.
    const std::string whole = summary_json(full_summary());
    std::string broken = whole;
    broken.replace(broken.find("\"rows\": 3"), 9, "\"rows\": []");
    EXPECT_THROW((void)read_run_summary(broken), std::runtime_error);
    EXPECT_THROW((void)read_sweep_summary(whole), std::runtime_error);
}

} // namespace
