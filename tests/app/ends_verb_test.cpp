#include "rheometry/end_effect.hpp"
#include "tests/app/running.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace {

using searle::app::testing::Outcome;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;
using searle::rheometry::EndEffect;

const std::string cases = std::string(SEARLE_SOURCE_DIR) + "/cases/";
const std::string water = cases + "din-bob-water.toml";
const std::string slurry = cases + "din-bob-slurry.toml";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// 1.0893: independent finite elements for the 14/15.2/42 mm bob, Newtonian (physics.md, section
/// 3).
TEST(EndsVerb, water_has_the_newtonian_factor_at_every_speed) {
    const TemporaryFolder folder;
    const Outcome outcome = searle({"ends", water, "--csv", "-o", "ends.csv"}, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto rows = searle::rheometry::read_end_effect_csv(folder / "ends.csv");
    EXPECT_EQ(rows.size(), 12U);
    for (const EndEffect& row : rows) {
        EXPECT_NEAR(row.end_factor, 1.0893, row.error + 5e-5);
        EXPECT_LE(row.lower, row.end_factor);
        EXPECT_GE(row.upper, row.end_factor);
        EXPECT_LT(row.error, 1e-3 * row.end_factor);
    }
}

/// Inertia adds Re^2 at first (tests/solvers/meridional_steady_test.cpp) and at 100 1/s far more
/// than the standards' c_L = 1.10 allows for.
TEST(EndsVerb, inertia_raises_the_factor_with_the_speed) {
    const TemporaryFolder folder;
    const auto table = [&](std::vector<std::string> further) {
        std::vector<std::string> words{"ends",  water, "--rates", "0.3,3,30",
                                       "--csv", "-o",  "ends.csv"};
        words.insert(words.end(), further.begin(), further.end());
        EXPECT_EQ(searle(words, folder.path()).exit_code, 0);
        return searle::rheometry::read_end_effect_csv(folder / "ends.csv");
    };
    const auto rows = table({});
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_NEAR(rows[0].with_inertia, rows[0].end_factor, 1e-3);
    EXPECT_GT(rows[1].with_inertia, rows[0].with_inertia);
    EXPECT_GT(rows[2].with_inertia, 1.15);
    EXPECT_LT(rows[2].with_inertia_error, 1e-3 * rows[2].with_inertia);
    for (const EndEffect& row : table({"--set", "solver.secondary_flow=false"})) {
        EXPECT_TRUE(std::isnan(row.with_inertia));
    }
}

TEST(EndsVerb, json_and_text_hold_the_rates_asked_for) {
    const TemporaryFolder folder;
    const Outcome json = searle({"ends", slurry, "--rates", "1,10", "--json"}, folder.path());
    ASSERT_EQ(json.exit_code, 0) << json.err;
    const auto read = nlohmann::json::parse(json.out);
    ASSERT_EQ(read.at("rows").size(), 2U);
    EXPECT_EQ(read.at("rows")[0].at("shear_rate_1_s"), 1.0);
    EXPECT_GT(read.at("rows")[0].at("end_factor"), read.at("rows")[1].at("end_factor"));
    const Outcome text = searle({"ends", slurry, "--rates", "1:100:3"}, folder.path());
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_TRUE(holds(text.out, "energy bounds")) << text.out;
}

TEST(EndsVerb, wrong_use_is_told) {
    const TemporaryFolder folder;
    EXPECT_EQ(searle({"ends", slurry, "--rates", "10:1:3"}, folder.path()).exit_code, 2);
    EXPECT_EQ(searle({"ends", slurry, "--rates", "-1"}, folder.path()).exit_code, 2);
    EXPECT_EQ(searle({"ends", slurry, "--rates", "fast"}, folder.path()).exit_code, 2);
    EXPECT_EQ(searle({"ends", slurry, "--csv", "--json"}, folder.path()).exit_code, 2);
    EXPECT_EQ(searle({"ends", "none.toml"}, folder.path()).exit_code, 2);
    const Outcome endless = searle({"ends", cases + "single-gap-water.toml"}, folder.path());
    EXPECT_EQ(endless.exit_code, 4);
    EXPECT_TRUE(holds(endless.err, "without ends")) << endless.err;
}

TEST(EndsVerb, a_run_writes_its_end_factors_and_the_report_shows_them) {
    const TemporaryFolder folder;
    ASSERT_EQ(searle({"run", slurry, "-o", "out", "--set", "solver.accuracy=0.01"}, folder.path())
                  .exit_code,
              0);
    const auto rows = searle::rheometry::read_end_effect_csv(folder / "out/end_factor.csv");
    EXPECT_EQ(rows.size(), 20U);
    const std::string page = text_of(folder / "out/report.html");
    EXPECT_TRUE(holds(page, "computed for each speed"));
    EXPECT_TRUE(holds(page, "end_factor.csv"));
    ASSERT_EQ(searle({"report", "out"}, folder.path()).exit_code, 0);
    EXPECT_TRUE(text_of(folder / "out/report.html") == page);
    write_text(folder / "out/end_factor.csv", "a,b\n1,2\n");
    EXPECT_EQ(searle({"report", "out"}, folder.path()).exit_code, 2);
}

} // namespace
