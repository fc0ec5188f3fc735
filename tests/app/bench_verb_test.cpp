#include "app/bench/bench_scenes.hpp"
#include "app/bench/bench_text.hpp"
#include "app/bench/native_run.hpp"
#include "app/bench/work_precision.hpp"
#include "tests/app/running.hpp"

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace searle::app::bench {
namespace {

using testing::Outcome;
using testing::Start;
using testing::TemporaryFolder;
using testing::text_of;

// cost = error^(-1/2) through four points: between them the line in log-log is exact.
const std::vector<WorkPoint> square_root_law{{1e-2, 10.0}, {1e-4, 100.0}, {1e-6, 1000.0}};

TEST(WorkPrecision, a_power_law_is_interpolated_exactly) {
    const auto best = best_points(square_root_law);
    ASSERT_EQ(best.size(), 3U);
    for (const double error : {9e-3, 1e-3, 1e-4, 3e-6, 1e-6})
        EXPECT_NEAR(work_at(best, error).cpu * std::sqrt(error), 1.0, 1e-12) << error;
}

TEST(WorkPrecision, outside_of_the_curve_there_is_a_bound_or_nothing) {
    const auto best = best_points(square_root_law);
    EXPECT_EQ(work_at(best, 1e-1).cpu, 10.0);
    EXPECT_TRUE(work_at(best, 1e-1).beyond);
    EXPECT_FALSE(work_at(best, 1e-3).beyond);
    EXPECT_TRUE(std::isnan(work_at(best, 1e-7).cpu));
    EXPECT_TRUE(std::isnan(work_at({}, 1e-3).cpu));
}

TEST(WorkPrecision, points_that_are_dearer_and_worse_do_not_count) {
    const auto best = best_points(
        {{1e-3, 5.0}, {1e-2, 7.0}, {1e-4, 50.0}, {1e-4, 40.0}, {unknown, 1.0}, {1e-1, 0.0}});
    ASSERT_EQ(best.size(), 2U);
    EXPECT_EQ(best[0].cpu, 5.0);
    EXPECT_EQ(best[1].cpu, 40.0);
}

TEST(WorkPrecision, errors_below_the_reference_s_own_count_as_that) {
    SceneResult scene;
    scene.name = "scene";
    scene.reference_error = 1e-3;
    scene.points = {{.code = "searle", .setting = "a", .true_error = 1e-9, .cpu_median = 2.0},
                    {.code = "peer", .setting = "b", .true_error = 1e-3, .cpu_median = 8.0}};
    BenchResult result;
    result.scenes = {scene};
    const auto ratios = ratios_of(result);
    ASSERT_EQ(ratios.size(), 1U);
    EXPECT_EQ(ratios[0].ratio, 4.0);
    EXPECT_FALSE(ratios[0].at_least);
}

TEST(BenchScenes, every_case_is_valid_at_every_accuracy_and_names_differ) {
    std::set<std::string> names;
    for (const BenchScene& scene : bench_scenes()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_FALSE(scene.accuracies.empty());
        for (const double accuracy : scene.accuracies)
            EXPECT_EQ(case_of(scene, accuracy).scene.solver.accuracy, accuracy) << scene.name;
    }
    EXPECT_GE(names.size(), 15U);
}

/// The scenes with a truth from outside, solved at 1e-3: their torques are right to that.
TEST(BenchScenes, closed_forms_agree_with_the_solver) {
    for (const BenchScene& scene : bench_scenes()) {
        if (scene.truth == Truth::finer_run || scene.truth == Truth::known_value)
            continue;
        const NativeRun run = run_native(case_of(scene, 1e-3), 0.0, 60.0, {});
        ASSERT_EQ(run.fault, "") << scene.name;
        const double error = true_error(scene, reference_for(scene, 60.0, {}), run.torques);
        EXPECT_LT(error, 1e-3) << scene.name;
        EXPECT_LE(error, run.estimate) << scene.name;
        EXPECT_GT(run.peak_MiB, 1.0);
        EXPECT_GT(run.cpu.at(0), 0.0);
    }
}

TEST(Apart, faults_come_back_as_text_and_crashes_stay_there) {
    EXPECT_EQ(work_apart(
                  [] {
                      return std::vector{1.0, 2.5};
                  },
                  10.0, {})
                  .values,
              (std::vector{1.0, 2.5}));
    EXPECT_EQ(
        work_apart([]() -> std::vector<double> { throw std::runtime_error("no"); }, 10.0, {}).fault,
        "no");
    const Ended crashed = work_apart(
        []() -> std::vector<double> {
            std::signal(SIGSEGV, SIG_DFL);
            raise(SIGSEGV);
            return {};
        },
        10.0, {});
    EXPECT_NE(crashed.fault, "");
    EXPECT_TRUE(crashed.values.empty());
    const Ended late = work_apart(
        []() -> std::vector<double> {
            for (;;)
                usleep(1000);
        },
        0.05, {});
    EXPECT_TRUE(late.timed_out);
}

TEST(BenchVerb, measures_scenes_into_a_folder_of_all_formats) {
    const TemporaryFolder place;
    const Outcome run = testing::searle(
        {"bench", "slurry-steady", "box", "--quick", "--no-peers", "-o", "out", "--json"},
        place.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(testing::names_in(place / "out"),
              "bench.csv bench.html bench.json bench.md readme.md summary.json");
    EXPECT_EQ(run.out, text_of(place / "out/bench.json"));
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json.at("scenes").size(), 2U);
    EXPECT_EQ(json["scenes"][0]["name"], "slurry-steady"); // in the order asked for
    for (const auto& scene : json["scenes"])
        for (const auto& point : scene["points"])
            EXPECT_LE(point["true_error"].get<double>(), point["error_estimate"].get<double>());
    EXPECT_TRUE(
        text_of(place / "out/bench.csv").starts_with("scene,code,setting,asked,true_error"));
    EXPECT_NE(text_of(place / "out/bench.html").find("<svg"), std::string::npos);
    // Results are replaced only when asked for.
    EXPECT_EQ(testing::searle({"bench", "slurry-steady", "-o", "out"}, place.path()).exit_code, 2);
    EXPECT_EQ(
        testing::searle({"bench", "slurry-steady", "--quick", "--no-peers", "--force", "-o", "out"},
                        place.path())
            .exit_code,
        0);
}

TEST(BenchVerb, an_unknown_scene_is_exit_2_and_names_the_nearest) {
    const TemporaryFolder place;
    const Outcome run = testing::searle({"bench", "din-creping"}, place.path());
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("did you mean 'din-creeping'"), std::string::npos) << run.err;
    EXPECT_EQ(testing::names_in(place.path()), "");
}

TEST(BenchVerb, an_interrupt_keeps_what_was_measured) {
    const TemporaryFolder place;
    const Outcome run = testing::run(
        {.arguments = {"bench", "slurry-steady", "suspension-dense", "--no-peers", "-o", "out"},
         .directory = place.path(),
         .signal = SIGINT,
         .signal_when = "suspension-dense"});
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_NE(text_of(place / "out/bench.csv").find("slurry-steady,searle"), std::string::npos);
    EXPECT_NE(text_of(place / "out/bench.json").find("\"interrupted\": true"), std::string::npos);
}

/// The README's table is what `searle bench --readme` prints: its markers, its header, and rows of
/// six cells that end in a ratio.
TEST(BenchVerb, readme_s_table_has_the_format_of_the_program) {
    const std::string readme = text_of(std::filesystem::path(SEARLE_SOURCE_DIR) / "README.md");
    const auto from = readme.find(readme_begin);
    const auto to = readme.find(readme_end);
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    const std::string block = readme.substr(from, to - from);
    const std::string empty = readme_block({});
    const auto header = empty.substr(0, empty.find("|---|---|---|---|---|---|\n") + 26);
    EXPECT_TRUE(block.starts_with(header)) << block;
    const std::regex row(R"(\| [^|]+ \| [^|]+ \| [^|]+ \| [^|]+ \| [^|]+ \| (> )?[0-9.]+ \|)");
    std::istringstream lines(block.substr(header.size()));
    int rows = 0;
    for (std::string line; std::getline(lines, line) && !line.empty(); ++rows)
        EXPECT_TRUE(std::regex_match(line, row)) << line;
    EXPECT_GE(rows, 8);
}

} // namespace
} // namespace searle::app::bench
