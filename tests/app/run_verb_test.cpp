#include "app/summary_json.hpp"
#include "rheometry/rheogram_csv.hpp"
#include "tests/app/running.hpp"

#include <numbers>

namespace {

namespace fs = std::filesystem;
using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string water = std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml";
const std::string box = std::string(SEARLE_SOURCE_DIR) + "/cases/box-water.toml";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string first_line(const fs::path& file) {
    const std::string text = text_of(file);
    return text.substr(0, text.find('\n'));
}

constexpr auto sweep_text = R"(title = "Two gaps"
[geometry]
type = "single-gap"
bob_radius = "14 mm"
cup_radius = "15 mm"
height = "42 mm"
[fluid]
model = "newtonian"
viscosity = "1 mPa.s"
density = "1000 kg/m^3"
[protocol]
type = "ramp"
from = "0 1/s"
to = "50 1/s"
duration = "10 s"
points = 5
[sweep]
vary = { "geometry.cup_radius" = ["14.5 mm", "15 mm"] }
)";

TEST(RunVerb, writes_the_result_folder_and_says_where) {
    const TemporaryFolder folder;
    const Outcome outcome = searle({"run", water}, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "results go to files";
    EXPECT_EQ(names_in(folder.path()), "results");
    EXPECT_EQ(names_in(folder / "results"), "single-gap-water");
    EXPECT_EQ(names_in(folder / "results/single-gap-water"),
              "case.toml report.html rheogram.csv summary.json");
    EXPECT_TRUE(holds(outcome.err, "results/single-gap-water/report.html")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "largest error")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "100 points")) << outcome.err;
}

TEST(RunVerb, csv_begins_with_the_columns_that_scripts_depend_on) {
    // The contract of the result folder: these names, in this order; further columns may follow.
    const TemporaryFolder folder;
    ASSERT_EQ(searle({"run", water, "-o", "gap"}, folder.path()).exit_code, 0);
    ASSERT_EQ(searle({"run", box, "-o", "box"}, folder.path()).exit_code, 0);
    EXPECT_TRUE(first_line(folder / "gap/rheogram.csv")
                    .starts_with("time_s,angular_velocity_rad_s,torque_N_m,shear_rate_1_s,"
                                 "shear_stress_Pa,viscosity_Pa_s,stress_error_Pa,regime"));
    EXPECT_TRUE(first_line(folder / "box/rheogram.csv")
                    .starts_with("time_s,wall_speed_m_s,wall_force_N,shear_rate_1_s,"
                                 "shear_stress_Pa,viscosity_Pa_s,stress_error_Pa,regime"));
    const std::string csv = text_of(folder / "gap/rheogram.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 101);
}

TEST(RunVerb, the_resolved_case_gives_the_same_rheogram_byte_for_byte) {
    const TemporaryFolder folder;
    for (const std::string& file : {water, box}) {
        ASSERT_EQ(searle({"run", file, "-o", "one", "--force"}, folder.path()).exit_code, 0);
        ASSERT_EQ(searle({"run", "one/case.toml", "-o", "two", "--force"}, folder.path()).exit_code,
                  0);
        EXPECT_EQ(text_of(folder / "one/rheogram.csv"), text_of(folder / "two/rheogram.csv"));
        EXPECT_EQ(text_of(folder / "one/case.toml"), text_of(folder / "two/case.toml"));
    }
}

TEST(RunVerb, report_makes_the_same_page_again) {
    const TemporaryFolder folder;
    for (const std::string& file : {water, box}) {
        ASSERT_EQ(searle({"run", file, "-o", "out", "--force"}, folder.path()).exit_code, 0);
        const std::string page = text_of(folder / "out/report.html");
        EXPECT_GT(page.size(), 10'000U);
        fs::remove(folder / "out/report.html");
        const Outcome outcome = searle({"report", "out"}, folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(text_of(folder / "out/report.html") == page);
        EXPECT_EQ(names_in(folder / "out"), "case.toml report.html rheogram.csv summary.json");
    }
}

TEST(RunVerb, report_of_a_folder_without_results_is_exit_2) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "empty");
    write_text(folder / "other/summary.json", "{}");
    for (const char* name : {"empty", "other", "absent"}) {
        const Outcome outcome = searle({"report", name}, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << name;
        EXPECT_TRUE(holds(outcome.err, name)) << outcome.err;
    }
    EXPECT_EQ(names_in(folder / "empty"), "");
    // A table that was changed by hand into something else is named with its line.
    ASSERT_EQ(searle({"run", box, "-o", "out"}, folder.path()).exit_code, 0);
    write_text(folder / "out/rheogram.csv", "shear_rate_1_s,shear_stress_Pa\n1,abc\n");
    const Outcome outcome = searle({"report", "out"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "rheogram.csv:2")) << outcome.err;
}

TEST(RunVerb, quiet_prints_nothing) {
    const TemporaryFolder folder;
    const Outcome outcome = searle({"run", water, "--quiet"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(RunVerb, set_changes_the_case) {
    const TemporaryFolder folder;
    ASSERT_EQ(searle({"run", water, "--set", "protocol.points=7", "--set",
                      "geometry.cup_radius=16 mm", "--set", "solver.model=radial", "-o", "out"},
                     folder.path())
                  .exit_code,
              0);
    const auto table = searle::rheometry::read_rheogram_csv(folder / "out/rheogram.csv");
    ASSERT_EQ(table.rheogram.points.size(), 7U);
    // bob-wall rate factor 2 delta^2/(delta^2 - 1) with delta = 16/14 is 128/15.
    EXPECT_NEAR(table.rheogram.points.back().shear_rate / table.rheogram.points.back().speed,
                128.0 / 15.0, 1e-12);
    // The case's name is that of the file, whatever was set.
    EXPECT_TRUE(holds(text_of(folder / "out/summary.json"), "\"single-gap-water\""));
}

TEST(RunVerb, summary_holds_what_the_contract_names) {
    const TemporaryFolder folder;
    ASSERT_EQ(searle({"run", water, "-o", "out"}, folder.path()).exit_code, 0);
    const auto summary = searle::app::read_run_summary(text_of(folder / "out/summary.json"));
    EXPECT_EQ(summary.title, "Water in a 1 mm gap");
    EXPECT_EQ(summary.origin.file, "single-gap-water.toml");
    EXPECT_EQ(summary.origin.hash.size(), 16U);
    EXPECT_TRUE(summary.versions.contains("searle"));
    EXPECT_TRUE(summary.versions.contains("compiler"));
    EXPECT_TRUE(summary.versions.contains("Boost"));
    EXPECT_EQ(summary.solver.engine, "native");
    EXPECT_FALSE(summary.solver.model_reason.empty());
    EXPECT_EQ(summary.conversion.definition, "bob-wall");
    EXPECT_EQ(summary.conversion.end_factor, 1.0);
    // 1/(2 pi L R^2) and 2 delta^2/(delta^2 - 1) for 14/15/42 mm.
    EXPECT_NEAR(summary.conversion.stress_per_torque,
                1.0 / (2.0 * std::numbers::pi * 0.042 * 0.014 * 0.014), 1e-9);
    EXPECT_NEAR(summary.conversion.rate_per_speed, 450.0 / 29.0, 1e-12);
    ASSERT_TRUE(summary.taylor.has_value());
    // Re = R omega d / nu at 100 1/s, nu = 1.0016e-3/998.2.
    EXPECT_NEAR(summary.taylor->reynolds, 0.014 * (100.0 * 29.0 / 450.0) * 0.001 / 1.00340613e-6,
                1e-4);
    EXPECT_EQ(summary.rows, 100);
    long rows = 0;
    for (const auto& [regime, count] : summary.regimes)
        rows += count;
    EXPECT_EQ(rows, 100);
    EXPECT_GE(summary.timings.size(), 4U);
    EXPECT_LE(summary.solver.worst_relative_error, 1e-3);
}

TEST(RunVerb, a_sweep_gives_a_folder_a_run_and_one_figure) {
    const TemporaryFolder folder;
    write_text(folder / "gaps.toml", sweep_text);
    const Outcome outcome = searle({"run", "gaps.toml"}, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const fs::path results = folder / "results/gaps";
    const auto summary = searle::app::read_sweep_summary(text_of(results / "summary.json"));
    ASSERT_EQ(summary.runs.size(), 2U);
    EXPECT_EQ(summary.swept_keys, std::vector<std::string>{"geometry.cup_radius"});
    EXPECT_EQ(summary.runs[0].swept_values, std::vector<std::string>{"14.5 mm"});
    for (const auto& each : summary.runs)
        EXPECT_EQ(names_in(results / each.name), "case.toml report.html rheogram.csv summary.json");
    const std::string table = text_of(results / "rheograms.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 11) << table;
    EXPECT_TRUE(table.starts_with("case,time_s,angular_velocity_rad_s,"));
    EXPECT_TRUE(holds(table, "\n" + summary.runs[1].name + ","));
    const std::string page = text_of(results / "report.html");
    EXPECT_TRUE(holds(page, summary.runs[0].name + "/report.html"));

    fs::remove(results / "report.html");
    fs::remove(results / summary.runs[0].name / "report.html");
    EXPECT_EQ(searle({"report", "results/gaps"}, folder.path()).exit_code, 0);
    EXPECT_TRUE(text_of(results / "report.html") == page);
    EXPECT_TRUE(fs::exists(results / summary.runs[0].name / "report.html"));

    EXPECT_EQ(searle({"run", "gaps.toml"}, folder.path()).exit_code, 2);
    EXPECT_EQ(searle({"run", "gaps.toml", "--force"}, folder.path()).exit_code, 0);
    EXPECT_EQ(names_in(folder / "results"), "gaps");
}

TEST(RunVerb, a_run_named_like_a_file_of_the_folder_is_refused) {
    const TemporaryFolder folder;
    const std::string text = sweep_text;
    write_text(folder / "gaps.toml",
               text.substr(0, text.find("[sweep]")) +
                   "[[sweep.runs]]\nname = \"a\"\n[[sweep.runs]]\nname = \"summary.json\"\n");
    const Outcome outcome = searle({"run", "gaps.toml"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "summary.json")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "gaps.toml");
}

} // namespace
