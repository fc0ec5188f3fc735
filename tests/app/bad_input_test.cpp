#include "tests/app/running.hpp"

#include <array>

// What users do wrong, given to the real program: a clear message, the right exit code, and nothing
// left behind.

namespace {

namespace fs = std::filesystem;
using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::Start;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string water = std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The water case with one piece of its text replaced.
std::string water_with(const std::string& before, const std::string& after) {
    std::string text = text_of(water);
    const auto at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return text.replace(at, before.size(), after);
}

/// Where a key of the water case stands: "bad.toml:12".
std::string place_of(const std::string& key) {
    const std::string text = text_of(water);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find('\n' + key + " = ") + 1);
    return "bad.toml:" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

class BadInput : public ::testing::Test {
protected:
    /// Runs a case file of this text; the message must hold every part, and nothing may appear.
    void expect_refusal(const std::string& text, const std::vector<std::string>& parts) {
        write_text(folder / "bad.toml", text);
        const Outcome outcome = searle({"run", "bad.toml"}, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        for (const std::string& part : parts)
            EXPECT_TRUE(holds(outcome.err, part)) << "no '" << part << "' in:\n" << outcome.err;
        EXPECT_LT(outcome.err.size(), 20'000U) << "a message that nobody reads";
        EXPECT_EQ(names_in(folder.path()), "bad.toml");
    }

    TemporaryFolder folder;
};

TEST_F(BadInput, file_that_is_not_there) {
    const Outcome outcome = searle({"run", "absent.toml"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "absent.toml")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST_F(BadInput, directory_in_place_of_a_file) {
    fs::create_directory(folder / "dir.toml");
    const Outcome outcome = searle({"run", "dir.toml"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "dir.toml")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "dir.toml");
}

TEST_F(BadInput, text_that_is_not_toml) {
    expect_refusal("Dear Searle, please measure water.\n", {"bad.toml:1"});
    expect_refusal("[geometry\ntype = 1\n", {"bad.toml:1"});
    expect_refusal("", {"bad.toml", "is empty", "searle new"});
    expect_refusal(std::string("\x7f\x45LF\0\x01\x02\xff\xfe", 9), {"bad.toml"});
    expect_refusal(std::string(4000, '['), {"bad.toml"});
}

TEST_F(BadInput, hundred_megabytes) {
    write_text(folder / "big.toml", "");
    fs::resize_file(folder / "big.toml", 100'000'000); // zeros, not stored
    const Outcome outcome = searle({"run", "big.toml"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "big.toml")) << outcome.err.substr(0, 500);
    EXPECT_LT(outcome.err.size(), 2000U);
}

TEST_F(BadInput, keys_unknown_missing_and_double) {
    expect_refusal(water_with("cup_radius =", "cup_radios ="),
                   {place_of("cup_radius"), "cup_radios", "cup_radius"});
    expect_refusal(water_with("height = \"42 mm\"\n", ""), {"geometry.height"});
    expect_refusal(water_with("height = \"42 mm\"", "height = \"42 mm\"\nheight = \"43 mm\""),
                   {"bad.toml:", "height is given twice, first on line"});
    expect_refusal(water_with("[solver]", "[solwer]"), {"solwer", "solver"});
    expect_refusal(water_with("viscosity =", "yield_stress = \"1 Pa\"\nviscosity ="),
                   {"yield_stress", "newtonian"});
}

TEST_F(BadInput, units_wrong_and_missing) {
    expect_refusal(water_with("\"14 mm\"", "\"14 mPa\""),
                   {place_of("bob_radius"), "bob_radius", "14 mPa"});
    expect_refusal(water_with("\"14 mm\"", "14"), {place_of("bob_radius"), "bob_radius", "unit"});
    expect_refusal(water_with("\"14 mm\"", "\"14\""), {place_of("bob_radius"), "bob_radius"});
    expect_refusal(water_with("\"35 s\"", "\"35 flurbs\""), {"duration", "flurbs"});
}

TEST_F(BadInput, numbers_that_are_none_or_impossible) {
    for (const char* value : {"nan mm", "inf mm", "-14 mm", "0 mm", "1e400 mm", "1,4 mm"})
        expect_refusal(water_with("\"14 mm\"", '"' + std::string(value) + '"'),
                       {place_of("bob_radius"), "bob_radius", value});
    expect_refusal(water_with("\"0.1 %\"", "nan"), {"accuracy"});
    expect_refusal(water_with("\"0.1 %\"", "1e-11"), {"accuracy"});
    expect_refusal(water_with("\"0.1 %\"", "\"100 %\""), {"accuracy"});
}

TEST_F(BadInput, bob_that_does_not_fit_into_the_cup) {
    // Both lines are named, since either may be the wrong one.
    for (const char* cup : {"\"14 mm\"", "\"1.5 mm\""})
        expect_refusal(water_with("\"15 mm\"", cup),
                       {place_of("cup_radius"), " | bob_radius = ", "bob_radius < cup_radius"});
}

TEST_F(BadInput, ramps_of_no_time_and_of_no_or_too_many_points) {
    expect_refusal(water_with("\"35 s\"", "\"0 s\""), {"duration", "0 s"});
    expect_refusal(water_with("points = 100", "points = 0"), {"points", "0"});
    expect_refusal(water_with("points = 100", "points = 1000000000"), {"points", "1000000000"});
    expect_refusal(water_with("points = 100", "points = 1.5"), {"points", "1.5"});
}

TEST_F(BadInput, all_faults_of_a_file_at_once) {
    std::string text = water_with("\"14 mm\"", "\"-14 mm\"");
    text.replace(text.find("points = 100"), 12, "points = -1");
    text.replace(text.find("\nviscosity"), 10, "\nviskosity");
    expect_refusal(text, {"bob_radius", "points", "viskosity"});
}

TEST_F(BadInput, set_with_a_wrong_key_or_value) {
    for (const char* words : {"geometry.bob=1 mm", "geometry.bob_radius", "=", "protocol.points=x",
                              "geometry.bob_radius=20 mm"}) {
        const Outcome outcome = searle({"run", water, "--set", words}, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << words;
        EXPECT_TRUE(holds(outcome.err, "--set")) << words << outcome.err;
    }
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST_F(BadInput, engines_and_models_that_are_not_here) {
    const std::string din = std::string(SEARLE_SOURCE_DIR) + "/cases/din-bob-water.toml";
    const std::vector<std::vector<std::string>> asks{{"run", din, "--set", "solver.model=3d"},
                                                     {"run", water, "--set", "solver.model=3d"}};
    for (const auto& words : asks) {
        const Outcome outcome = searle(words, folder.path());
        EXPECT_EQ(outcome.exit_code, 4) << words.back() << outcome.err;
        EXPECT_FALSE(outcome.err.empty());
        EXPECT_EQ(names_in(folder.path()), "");
    }
}

TEST_F(BadInput, output_place_that_cannot_take_results) {
    write_text(folder / "file", "mine");
    fs::create_directory(folder / "full");
    write_text(folder / "full/mine.txt", "mine");
    const std::array<std::pair<std::string, std::string>, 3> places{
        {{"file", "is a file"}, {"file/below", "is a file"}, {"full", "mine.txt"}}};
    for (const auto& [place, part] : places) {
        const Outcome outcome = searle({"run", water, "-o", place, "--force"}, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << place;
        EXPECT_TRUE(holds(outcome.err, part)) << outcome.err;
    }
    EXPECT_EQ(names_in(folder.path()), "file full");
    EXPECT_EQ(text_of(folder / "file") + text_of(folder / "full/mine.txt"), "minemine");
}

TEST_F(BadInput, output_place_is_looked_at_before_the_solving) {
    // At 1e-10 and 100 000 points the ramp takes far longer than this test may.
    ASSERT_EQ(searle({"run", water}, folder.path()).exit_code, 0);
    const std::string before = text_of(folder / "results/single-gap-water/rheogram.csv");
    const Outcome outcome = searle({"run", water, "--set", "solver.accuracy=1e-10", "--set",
                                    "protocol.points=100000", "--set", "protocol.duration=1e5 s"},
                                   folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "--force")) << outcome.err;
    EXPECT_EQ(text_of(folder / "results/single-gap-water/rheogram.csv"), before);
}

TEST_F(BadInput, output_place_without_the_right_to_write) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can become another user";
    fs::create_directory(folder / "theirs");
    fs::permissions(folder.path(), fs::perms(0755));
    const Outcome outcome = run({.arguments = {"run", water, "-o", "theirs/out"},
                                 .directory = folder.path(),
                                 .user = 65534});
    if (outcome.exit_code == 126 || outcome.exit_code == 127)
        GTEST_SKIP() << "the other user cannot reach the program";
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "cannot be written")) << outcome.err;
    EXPECT_EQ(names_in(folder / "theirs"), "");
}

TEST_F(BadInput, full_disk) {
    // A limit on the size of files stands for a full disk; the report is larger than that.
    const Outcome outcome =
        run({.arguments = {"run", water}, .directory = folder.path(), .file_size_limit = 4096});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "could not be written")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "") << "neither results nor their parent folder stays";
}

TEST_F(BadInput, interrupt_keeps_what_was_finished_and_says_so) {
    const std::vector<std::string> long_run{"run",   water,
                                            "-o",    "out",
                                            "--set", "solver.accuracy=1e-10",
                                            "--set", "protocol.points=100000",
                                            "--set", "protocol.duration=1e5 s"};
    for (const int signal : {SIGINT, SIGTERM}) {
        std::vector<std::string> arguments = long_run;
        arguments.emplace_back("--force");
        const Outcome outcome = run({.arguments = arguments,
                                     .directory = folder.path(),
                                     .signal = signal,
                                     .signal_when = "searle: "});
        EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, "nterrupted")) << outcome.err;
        if (names_in(folder.path()).empty()) // before the first row there is nothing to keep
            continue;
        EXPECT_EQ(names_in(folder.path()), "out");
        EXPECT_EQ(names_in(folder / "out"), "case.toml report.html rheogram.csv summary.json");
        EXPECT_TRUE(holds(text_of(folder / "out/summary.json"), "\"interrupted\": true"));
    }
}

} // namespace
