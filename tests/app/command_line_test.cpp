#include "tests/app/running.hpp"

namespace {

using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;

const std::vector<std::string> working_verbs{"run",     "collect", "compare", "plan",   "check",
                                             "convert", "report",  "new",     "schema", "doctor",
                                             "fit",     "mesh",    "bench",   "verify", "stress"};

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(CommandLine, help_lists_every_verb_and_has_an_example) {
    for (const char* flag : {"--help", "-h"}) {
        const Outcome help = searle({flag}, "/");
        EXPECT_EQ(help.exit_code, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_TRUE(holds(help.out, "Example: searle run"));
        for (const std::string& verb : working_verbs)
            EXPECT_TRUE(holds(help.out, "\n  " + verb + " ")) << verb << help.out;
    }
}

TEST(CommandLine, every_verb_has_help_with_an_example) {
    for (const std::string& verb : working_verbs) {
        const Outcome help = searle({verb, "--help"}, "/");
        EXPECT_EQ(help.exit_code, 0) << verb;
        EXPECT_TRUE(holds(help.out, "Example: searle " + verb)) << help.out;
    }
}

TEST(CommandLine, version_is_one_line) {
    const Outcome version = searle({"--version"}, "/");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_TRUE(version.out.starts_with("searle 0.")) << version.out;
    EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1);
}

TEST(CommandLine, wrong_usage_is_exit_2_with_a_hint_on_stderr) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> uses{
        {{}, "searle run"},
        {{"rnu", "a.toml"}, "no verb 'rnu' (did you mean 'run'?)"},
        {{"--fast"}, "--fast"},
        {{"run"}, "CASE is required"},
        {{"run", "a.toml", "b.toml"}, "b.toml"},
        {{"run", "a.toml", "--set"}, "--set"},
        {{"run", "a.toml", "--sett", "a=1"}, "--sett"},
        {{"new"}, "GEOMETRY is required"},
        {{"new", "triple-gap"}, "triple-gap"},
        {{"schema", "--json", "--markdown"}, "--markdown"},
        {{"report"}, "DIR is required"},
    };
    for (const auto& [words, part] : uses) {
        const Outcome outcome = searle(words, "/");
        EXPECT_EQ(outcome.exit_code, 2) << part;
        EXPECT_EQ(outcome.out, "") << part;
        EXPECT_TRUE(holds(outcome.err, part)) << outcome.err;
    }
}

TEST(CommandLine, doctor_names_engines_libraries_and_how_to_get_what_is_missing) {
    const Outcome outcome = searle({"doctor"}, "/");
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* part : {"native", "OpenFOAM", "Boost", "Eigen", "UDUNITS-2", "FreeXL"})
        EXPECT_TRUE(holds(outcome.out, part)) << part << '\n' << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "apt-get install openfoam") || holds(outcome.out, "pimpleFoam"))
        << outcome.out;
}

TEST(CommandLine, doctor_notices_that_the_units_are_missing) {
    const Outcome outcome = run({.arguments = {"-c", "UDUNITS2_XML_PATH=/nowhere " +
                                                         std::string(SEARLE_PROGRAM) + " doctor"},
                                 .program = "/bin/sh"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_TRUE(holds(outcome.out, "apt-get install libudunits2-data")) << outcome.out;
}

TEST(CommandLine, output_that_cannot_be_written_is_a_failure) {
    // /dev/full answers every write with "no space left on device".
    const Outcome outcome =
        run({.arguments = {"-c", std::string(SEARLE_PROGRAM) + " schema >/dev/full"},
             .program = "/bin/sh"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(holds(outcome.err, "standard output could not be written")) << outcome.err;
}

TEST(CommandLine, closed_standard_streams_do_not_end_up_in_results) {
    const TemporaryFolder folder;
    const std::string cases = std::string(SEARLE_SOURCE_DIR) + "/cases/";
    const Outcome outcome =
        run({.arguments = {"-c", std::string(SEARLE_PROGRAM) + " run " + cases +
                                     "single-gap-water.toml -o out <&- >&- 2>&-"},
             .directory = folder.path(),
             .program = "/bin/sh"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(searle::app::testing::text_of(folder / "out/rheogram.csv").starts_with("time_s,"));
}

} // namespace
