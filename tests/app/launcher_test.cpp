#include "tests/app/running.hpp"

#include <algorithm>

// The launcher is tried on a tiny project of its own, so that these tests neither install nor build
// Searle. Where the packages that it names are not installed (bash always is), nothing is fetched.

namespace {

using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

constexpr auto program_text = R"(#include <cstdio>
int main(int count, char** arguments) {
    for (int i = 1; i < count; ++i) std::printf("[%s]", arguments[i]);
    return count > 1 && arguments[1][0] == '7' ? 7 : 0;
}
)";

class Launcher : public ::testing::Test {
protected:
    void SetUp() override {
        project = folder / "a project with blanks";
        write_text(project / "CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.25)\nproject(tiny LANGUAGES CXX)\n"
                   "option(SEARLE_TESTS \"\" ON)\noption(SEARLE_BENCH \"\" ON)\n"
                   "add_executable(searle_program app/main.cpp)\n"
                   "set_target_properties(searle_program PROPERTIES OUTPUT_NAME searle)\n"
                   "if(SEARLE_TESTS)\n  enable_testing()\n"
                   "  add_test(NAME says_seven COMMAND searle_program 7)\nendif()\n");
        std::filesystem::copy_file(std::string(SEARLE_SOURCE_DIR) + "/CMakePresets.json",
                                   project / "CMakePresets.json");
        std::filesystem::copy_file(std::string(SEARLE_SOURCE_DIR) + "/searle", project / "searle");
        write_text(project / "packages.txt",
                   "# comment\n\n[searle]\nbash  # a comment\n[optional]\ndash");
        for (const char* room : {"casefile", "laws", "geometry", "rheometry", "solvers"})
            std::filesystem::create_directories(project / room);
        write_text(project / "app/main.cpp", program_text);
    }

    Outcome launch(std::vector<std::string> arguments) const {
        return run({.arguments = std::move(arguments),
                    .directory = folder.path(),
                    .program = project / "searle",
                    .close_stdin = true});
    }

    TemporaryFolder folder;
    std::filesystem::path project;
};

TEST_F(Launcher, builds_once_then_hands_over_arguments_and_exit_code) {
    const Outcome first = launch({"two words", "*", ""});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "[two words][*][]");
    EXPECT_NE(first.err.find("searle: building"), std::string::npos) << first.err;
    const Outcome second = launch({"7"});
    EXPECT_EQ(second.exit_code, 7);
    EXPECT_EQ(second.err, "");
}

TEST_F(Launcher, works_through_a_symbolic_link) {
    std::filesystem::create_symlink(project / "searle", folder / "link");
    std::filesystem::create_symlink("link", folder / "link to link");
    const Outcome outcome =
        run({.arguments = {"x"}, .directory = folder.path(), .program = folder / "link to link"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "[x]");
}

TEST_F(Launcher, builds_again_after_a_change_and_after_a_move) {
    ASSERT_EQ(launch({}).exit_code, 0);
    std::string changed = program_text;
    changed.replace(changed.find("[%s]"), 4, "<%s>");
    write_text(project / "app/main.cpp", changed);
    EXPECT_EQ(launch({"x"}).out, "<x>");

    std::filesystem::rename(project, folder / "elsewhere");
    project = folder / "elsewhere";
    const Outcome moved = launch({"y"});
    EXPECT_EQ(moved.out, "<y>") << moved.err;
}

TEST_F(Launcher, shows_the_end_of_the_log_of_a_failed_build) {
    write_text(project / "app/main.cpp", "int main() { return undeclared_name; }\n");
    const Outcome failed = launch({});
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_NE(failed.err.find("undeclared_name"), std::string::npos) << failed.err;
    const std::string log = (project / "build/release/launcher.log").string();
    EXPECT_NE(failed.err.find("the whole log is in " + log), std::string::npos) << failed.err;
    EXPECT_NE(text_of(log).find("undeclared_name"), std::string::npos);
    // The fault mended, the next call builds and runs.
    write_text(project / "app/main.cpp", program_text);
    EXPECT_EQ(launch({"x"}).out, "[x]");
}

TEST_F(Launcher, launches_at_the_same_time_do_not_disturb_each_other) {
    std::vector<Outcome> outcomes(4);
    std::vector<std::thread> threads;
    for (Outcome& outcome : outcomes)
        threads.emplace_back([&outcome, this] { outcome = launch({"x"}); });
    for (std::thread& thread : threads)
        thread.join();
    for (const Outcome& outcome : outcomes) {
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "[x]");
    }
}

TEST_F(Launcher, test_verb_ends_with_the_summary_of_ctest_and_its_exit_code) {
    const Outcome failing = launch({"test"}); // the program answers 7, so its test fails
    EXPECT_NE(failing.exit_code, 0);
    EXPECT_NE(failing.out.find("0% tests passed, 1 tests failed out of 1"), std::string::npos)
        << failing.out << failing.err;
    write_text(project / "app/main.cpp", "int main() {}\n");
    const Outcome passing = launch({"test"});
    EXPECT_EQ(passing.exit_code, 0);
    EXPECT_NE(passing.out.find("100% tests passed, 0 tests failed out of 1"), std::string::npos);
}

TEST_F(Launcher, names_the_packages_that_are_missing_and_cannot_be_installed) {
    if (geteuid() != 0 || std::filesystem::exists("/usr/bin/sudo"))
        GTEST_SKIP() << "needs a user who cannot install, which only root without sudo can become";
    write_text(project / "packages.txt", "[searle]\nbash\nno-such-package-1\nno-such-package-2\n");
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    std::filesystem::permissions(project, std::filesystem::perms::all);
    const Outcome outcome =
        run({.directory = folder.path(), .program = project / "searle", .user = 65534});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("these packages are missing: no-such-package-1 no-such-package-2\n"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("apt-get install --no-install-recommends no-such-package-1"),
              std::string::npos);
}

TEST(LauncherScript, watches_every_room_that_the_program_is_built_from) {
    // The rooms are the searle_room(NAME FOLDER folder ...) lines of CMakeLists.txt.
    const std::string script = text_of(std::string(SEARLE_SOURCE_DIR) + "/searle");
    const auto start = script.find("sources=(");
    ASSERT_NE(start, std::string::npos);
    const std::string watched =
        " " + script.substr(start + 9, script.find(')', start) - start - 9) + " ";
    const std::string project = text_of(std::string(SEARLE_SOURCE_DIR) + "/CMakeLists.txt");
    int rooms = 0;
    for (auto at = project.find("\nsearle_room("); at != std::string::npos;
         at = project.find("\nsearle_room(", at + 1), ++rooms) {
        const auto folder = project.find("FOLDER ", at) + 7;
        const std::string name =
            project.substr(folder, project.find_first_of(" )\n", folder) - folder);
        EXPECT_NE(watched.find(" " + name + " "), std::string::npos) << name;
    }
    EXPECT_GE(rooms, 5);
    EXPECT_NE(watched.find(" app "), std::string::npos);
}

} // namespace
