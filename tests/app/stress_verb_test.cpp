#include "app/case_reader.hpp"
#include "app/stress/draw.hpp"
#include "app/stress/random_case.hpp"
#include "app/stress/scene_trial.hpp"
#include "app/stress/stress_campaign.hpp"
#include "tests/app/running.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace searle::app {
namespace {

using testing::Outcome;
using testing::TemporaryFolder;
using testing::text_of;

Trial tried(const std::string& text, bool physical = true) {
    return try_scene({.kind = "by hand", .text = text, .physical = physical}, 60.0, {});
}

std::string gap_case(const std::string& rest) {
    return "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\n"
           "height = \"42 mm\"\n" +
           rest;
}

/// SplitMix64's first three numbers from the state 1234567, as its authors' code gives them
/// (Rosetta Code, "Pseudo-random numbers/Splitmix64").
TEST(StressDraw, is_split_mix_64) {
    std::uint64_t state = 1234567;
    const std::uint64_t expected[] = {6457827717110365317ULL, 3203168211198807973ULL,
                                      9817491932198370423ULL};
    for (const std::uint64_t each : expected)
        EXPECT_EQ(split_mix(state), each);
}

TEST(StressDraw, values_stay_in_their_ranges_and_reach_both_ends) {
    Draw draw(7, 3);
    double least = 1.0;
    double most = 0.0;
    std::set<int> seen;
    for (int k = 0; k < 20000; ++k) {
        const double value = draw.log_between(1e-3, 1e3);
        ASSERT_GE(value, 1e-3);
        ASSERT_LE(value, 1e3);
        const double unit = draw.unit();
        least = std::min(least, unit);
        most = std::max(most, unit);
        seen.insert(draw.integer(-1, 2));
    }
    EXPECT_LT(least, 1e-3);
    EXPECT_GT(most, 1.0 - 1e-3);
    EXPECT_EQ(seen, (std::set<int>{-1, 0, 1, 2}));
}

TEST(StressScenes, are_the_same_for_the_same_number_and_seed_and_differ_otherwise) {
    for (const std::string& family : stress_families()) {
        EXPECT_EQ(random_case(family, 5, 17).text, random_case(family, 5, 17).text);
        EXPECT_NE(random_case(family, 5, 17).text, random_case(family, 5, 18).text);
        EXPECT_NE(random_case(family, 5, 17).text, random_case(family, 6, 17).text);
    }
}

/// Every geometry, law and protocol comes up among some hundred scenes.
TEST(StressScenes, cover_geometries_laws_and_protocols) {
    std::string kinds;
    for (long number = 1; number <= 400; ++number)
        kinds += random_case("fluid", 1, number).kind + '\n';
    for (const char* word : {"single-gap", "double-gap", "box", "din-bob", "newtonian", "bingham",
                             "power-law", "herschel-bulkley", "casson", "carreau-yasuda", "cross",
                             "steady", "ramp", "up-down", "jumps"})
        EXPECT_NE(kinds.find(word), std::string::npos) << word;
}

TEST(StressScenes, need_no_other_program_unless_asked_for) {
    const std::vector<std::string> usual = usual_stress_families();
    EXPECT_EQ(std::ranges::count(usual, "openfoam"), 0);
    for (const std::string& family : usual)
        for (long number = 1; number <= 50; ++number)
            EXPECT_EQ(random_case(family, 1, number).text.find("engine"), std::string::npos);
}

/// The drawn time steps and cells reach OpenFOAM, and the cases are ones that it has: a plan can be
/// made of each.
TEST(StressScenes, for_openfoam_can_be_planned_and_half_of_those_in_time_are_forced) {
    int forced = 0;
    int in_time = 0;
    for (long number = 1; number <= 60; ++number) {
        const RandomCase scene = random_case("openfoam", 1, number);
        const std::vector<Case> cases = read_cases_text(scene.text, "scene.toml");
        ASSERT_EQ(cases.size(), 1U);
        EXPECT_EQ(cases.front().scene.solver.engine, solvers::Engine::openfoam);
        const bool steady = scene.kind.ends_with("steady");
        in_time += steady ? 0 : 1;
        forced += cases.front().scene.solver.time_step ? 1 : 0;
    }
    EXPECT_GT(forced, in_time / 4);
    EXPECT_LT(forced, in_time);
}

TEST(StressTrial, a_right_case_is_right_and_held_to_digits) {
    const Trial trial =
        tried(gap_case("[fluid]\nmodel = \"herschel-bulkley\"\nyield_stress = \"1 Pa\"\n"
                       "consistency = \"1 Pa.s^n\"\nflow_index = 0.5\ndensity = \"1000 kg/m^3\"\n"
                       "[protocol]\ntype = \"steps\"\nshear_rates = [\"10 1/s\"]\nhold = "
                       "\"steady\"\n[solver]\naccuracy = 1e-6\n"));
    EXPECT_EQ(trial.verdict, Verdict::right) << trial.reason;
    EXPECT_EQ(trial.truth, "50 digits");
    EXPECT_LE(trial.worst_ratio, 1.0);
    EXPECT_GT(trial.relative_error, 0.0);
}

TEST(StressTrial, a_faulty_case_is_refused_with_its_reason) {
    const Trial trial = tried("[geometry]\ntype = \"triple-gap\"\n");
    EXPECT_EQ(trial.verdict, Verdict::refused);
    EXPECT_NE(trial.reason.find("triple-gap"), std::string::npos) << trial.reason;
}

/// Found by a sweep: towards a stop, where the stress is singular in time, steps became so short
/// that fluxes were infinite, and an error that is no number passed for none.
TEST(StressTrial, a_stiff_plug_ramped_down_to_rest_ends_in_numbers) {
    const Trial trial = tried(R"([geometry]
type = "double-gap"
radii = ["0.0258612039 m", "0.0259925914 m", "0.0268497143 m", "0.0301649695 m"]
height = "0.0517224 m"
[fluid]
model = "bingham"
yield_stress = "0.0318193009 Pa"
plastic_viscosity = "0.00102004563 Pa.s"
density = "756.678 kg/m^3"
[protocol]
type = "segments"
segments = [{ to = "492.737 1/s", duration = "11.3164 s", points = 4 }, { to = "0 1/s", duration = "11.3164 s", points = 4 }]
[solver]
accuracy = 0.01875
model = "radial"
)");
    EXPECT_FALSE(is_failure(trial.verdict)) << name_of(trial.verdict) << ": " << trial.reason;
}

/// An accuracy beyond what vortices past the onset can be known to.
TEST(StressTrial, an_accuracy_out_of_reach_gave_up) {
    const Trial trial = tried(gap_case(
        "[fluid]\nmodel = \"newtonian\"\nviscosity = \"1 mPa.s\"\ndensity = \"1000 kg/m^3\"\n"
        "[protocol]\ntype = \"steps\"\nshear_rates = [\"5000 1/s\"]\nhold = \"steady\"\n"
        "[solver]\naccuracy = 1e-6\n"));
    EXPECT_EQ(trial.verdict, Verdict::gave_up) << trial.reason;
    EXPECT_FALSE(is_failure(trial.verdict));
    EXPECT_GT(trial.taylor_ratio, 1.0);
}

TEST(StressVerb, writes_a_table_goes_on_where_it_stopped_and_tells_json) {
    const TemporaryFolder folder;
    const std::string place = (folder / "sweep").string();
    const Outcome first = testing::searle(
        {"stress", "fluid", "--scenes", "12", "--seed", "9", "-o", place, "--quiet"},
        folder.path());
    EXPECT_EQ(first.exit_code, 0) << first.out << first.err;
    const std::string table = text_of(folder / "sweep" / "stress.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);
    // What stands there is not run again; a row cut off is.
    std::filesystem::resize_file(folder / "sweep" / "stress.csv", table.rfind("fluid,12,9") + 5);
    testing::write_text(folder / "sweep" / "stress.csv",
                        text_of(folder / "sweep" / "stress.csv") + "\n");
    const Outcome again = testing::searle(
        {"stress", "fluid", "--scenes", "12", "--seed", "9", "-o", place, "--json"}, folder.path());
    EXPECT_EQ(again.exit_code, 0) << again.err;
    const auto json = nlohmann::json::parse(again.out);
    EXPECT_EQ(json["complete"], true);
    EXPECT_EQ(json["fluid"]["scenes"], 12);
    EXPECT_EQ(json["fluid"]["failures"], 0);
    // Eleven of them come from the table.
    long below = 0;
    std::istringstream lines(table.substr(table.find('\n') + 1));
    for (std::string line; std::getline(lines, line);)
        below += std::stod(line.substr(line.rfind(',') + 1)) <= 1.0 ? 1 : 0;
    EXPECT_LT(below, 12);
    EXPECT_EQ(json["fluid"]["below_onset"], below);
    EXPECT_LE(json["fluid"]["right_below_onset"], below);
}

/// A sweep in two parts is the sweep in one.
TEST(StressVerb, begins_at_the_number_asked_for) {
    const TemporaryFolder folder;
    const auto table = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "stress", "fluid", "--seed", "9", "-o", (folder / name).string(), "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(testing::searle(words, folder.path()).exit_code, 0);
        // Without what a busy machine changes: the CPU time.
        std::string kept;
        std::istringstream lines(text_of(folder / name / "stress.csv"));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("fluid,3,") || line.starts_with("fluid,4,"))
                kept += line.substr(0, line.find(",RIGHT")) + '\n';
        return kept;
    };
    const std::string whole = table("whole", {"--scenes", "4"});
    EXPECT_EQ(whole, table("part", {"--first", "3", "--scenes", "2"}));
    EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 2);
}

TEST(StressVerb, wrong_usage_is_one_message_and_code_2) {
    const TemporaryFolder folder;
    testing::write_text(folder / "file", "x");
    const std::vector<std::vector<std::string>> wrong{{"stress", "fluids"},
                                                      {"stress", "--scenes", "0"},
                                                      {"stress", "--first", "0"},
                                                      {"stress", "--minutes", "-1"},
                                                      {"stress", "--scene-seconds", "0"},
                                                      {"stress", "-o", (folder / "file").string()}};
    for (const auto& arguments : wrong) {
        const Outcome outcome = testing::searle(arguments, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << arguments.back() << outcome.err;
        EXPECT_FALSE(outcome.err.empty());
    }
}

} // namespace
} // namespace searle::app
