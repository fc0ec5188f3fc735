#include "app/verify/check.hpp"
#include "app/verify/verify_text.hpp"
#include "tests/app/running.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace searle::app::verify {
namespace {

using testing::Outcome;
using testing::text_of;

std::filesystem::path in_project(const std::string& file) {
    return std::filesystem::path(SEARLE_SOURCE_DIR) / file;
}

/// "Suite.name" stands in the file as a TEST or TEST_P.
void expect_test(const std::string& file, const std::string& test) {
    const std::string text = text_of(in_project(file));
    const auto dot = test.find('.');
    const std::string macro = fmt::format("({}, {})", test.substr(0, dot), test.substr(dot + 1));
    EXPECT_NE(text.find("TEST" + macro), text.find("TEST_P" + macro)) << file << ' ' << test;
}

TEST(Verify, every_check_names_a_test_that_is_there) {
    std::set<std::string> names;
    for (const Check& check : all_checks()) {
        EXPECT_TRUE(names.insert(check.name).second) << check.name;
        EXPECT_GT(check.tolerance, 0.0) << check.name;
        EXPECT_FALSE(check.origin.empty()) << check.name;
        expect_test(check.file, check.test);
    }
    EXPECT_GE(names.size(), 40U);
    for (const SuiteOnly& row : suite_only())
        expect_test(row.file, row.test);
}

TEST(Verify, the_page_has_every_check_of_the_program_and_none_failed) {
    const std::string page = text_of(in_project("docs/verification.md"));
    for (const Check& check : all_checks()) {
        const auto at = page.find("| " + check.name + " | " + check.subject + " | ");
        ASSERT_NE(at, std::string::npos) << check.name
                                         << ": make the page anew by `searle verify "
                                            "--markdown > docs/verification.md`";
        EXPECT_NE(page.find(fmt::format(" | {:.1e} | {} | ", check.tolerance, check.origin), at),
                  std::string::npos)
            << check.name;
    }
    for (const SuiteOnly& row : suite_only())
        EXPECT_NE(page.find(row.test), std::string::npos) << row.test;
    EXPECT_EQ(page.find("**failed**"), std::string::npos);
}

TEST(Verify, a_wrong_value_a_low_order_and_an_exception_fail) {
    Check check;
    check.tolerance = 1e-6;
    check.run = [] { return Found{1e-7}; };
    EXPECT_TRUE(done(check).passed);
    check.run = [] { return Found{2e-6}; };
    EXPECT_FALSE(done(check).passed);
    check.run = [] { return Found{NAN}; };
    EXPECT_FALSE(done(check).passed);
    check.run = []() -> Found { throw std::runtime_error("broken"); };
    EXPECT_FALSE(done(check).passed);
    EXPECT_EQ(done(check).fault, "broken");
    check.least_order = 3.7;
    check.run = [] { return Found{1e-7, 3.0}; };
    EXPECT_FALSE(done(check).passed);
    check.run = [] { return Found{1e-7}; };
    EXPECT_FALSE(done(check).passed);
    check.run = [] { return Found{1e-7, 4.0}; };
    EXPECT_TRUE(done(check).passed);
}

TEST(VerifyVerb, quick_checks_pass_and_json_says_so) {
    const Outcome run =
        testing::searle({"verify", "laws", "gap", "conversion", "dlvo", "contact", "--json"}, "/");
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_TRUE(json.at("passed").get<bool>());
    EXPECT_GE(json.at("checks").size(), 15U);
    for (const auto& row : json["checks"]) {
        EXPECT_TRUE(row["passed"].get<bool>()) << row;
        EXPECT_LE(row["error"].get<double>(), row["tolerance"].get<double>()) << row;
    }
}

TEST(VerifyVerb, an_unknown_check_is_exit_2_and_names_the_nearest) {
    const Outcome run = testing::searle({"verify", "taylor-onsett"}, "/");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("did you mean 'taylor-onset'"), std::string::npos) << run.err;
}

} // namespace
} // namespace searle::app::verify
