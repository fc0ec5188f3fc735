#include "rheometry/rheogram_csv.hpp"
#include "tests/app/running.hpp"

#include <cmath>

namespace {

namespace fs = std::filesystem;
using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string cases = std::string(SEARLE_SOURCE_DIR) + "/cases/";
const std::string din_bob = cases + "din-bob-water.toml";
const std::string measured_case = cases + "measured-surfactant.toml";
const std::string measured = cases + "measured-surfactant.csv";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

class ConvertVerb : public ::testing::Test {
protected:
    Outcome convert(std::vector<std::string> words) const {
        words.insert(words.begin(), "convert");
        return searle(words, folder.path());
    }

    TemporaryFolder folder;
};

// 171.557 Pa at 999.973 1/s and 3.10196 Pa at 0.999995 1/s: the columns of the export.
TEST_F(ConvertVerb, measured_example_gives_what_its_comment_says) {
    const Outcome outcome = convert({measured, "--case", measured_case, "-o", "out.csv"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(holds(outcome.err, "iso-3219")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "16243.27")) << outcome.err;
    const auto rheogram = searle::rheometry::read_rheogram_csv(folder / "out.csv").rheogram;
    ASSERT_EQ(rheogram.points.size(), 41U);
    EXPECT_NEAR(rheogram.points[0].shear_stress, 171.557, 5e-4);
    EXPECT_NEAR(rheogram.points[0].shear_rate, 999.973, 5e-4);
    EXPECT_NEAR(rheogram.points[30].shear_stress, 3.10196, 5e-6);
    EXPECT_NEAR(rheogram.points[30].shear_rate, 0.999995, 5e-7);
}

TEST_F(ConvertVerb, without_a_file_the_same_table_goes_to_standard_output) {
    ASSERT_EQ(convert({measured, "--case", measured_case, "-o", "out.csv"}).exit_code, 0);
    const Outcome outcome = convert({measured, "--case", measured_case, "--quiet"});
    EXPECT_EQ(outcome.out, text_of(folder / "out.csv"));
    EXPECT_EQ(outcome.err, "");
}

// A torque that run computed, given to convert, must come out as the stress that run wrote.
TEST_F(ConvertVerb, what_run_computed_converts_to_what_run_wrote) {
    ASSERT_EQ(
        searle({"run", cases + "box-water.toml", "-o", "run", "--quiet"}, folder.path()).exit_code,
        0);
    const Outcome outcome = convert(
        {"run/rheogram.csv", "--case", cases + "box-water.toml", "-o", "out.csv", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto computed = searle::rheometry::read_rheogram_csv(folder / "run/rheogram.csv");
    const auto converted = searle::rheometry::read_rheogram_csv(folder / "out.csv");
    ASSERT_EQ(converted.rheogram.points.size(), computed.rheogram.points.size());
    EXPECT_EQ(converted.columns, searle::rheometry::DriveColumns::sliding);
    for (std::size_t row = 0; row < computed.rheogram.points.size(); ++row) {
        EXPECT_EQ(converted.rheogram.points[row].shear_stress,
                  computed.rheogram.points[row].shear_stress);
        EXPECT_EQ(converted.rheogram.points[row].shear_rate,
                  computed.rheogram.points[row].shear_rate);
    }
}

TEST_F(ConvertVerb, an_output_that_is_there_is_replaced_as_a_whole) {
    write_text(folder / "out.csv", "old");
    EXPECT_EQ(convert({measured, "--case", measured_case, "-o", "out.csv"}).exit_code, 0);
    EXPECT_TRUE(text_of(folder / "out.csv").starts_with("time_s,"));
    EXPECT_EQ(names_in(folder.path()), "out.csv");
}

TEST_F(ConvertVerb, faulty_data_touch_nothing_and_name_file_and_line) {
    write_text(folder / "lab.csv", "angular_velocity_rad_s,torque_N_m\n1,2\n1,much\n");
    write_text(folder / "out.csv", "old");
    const Outcome outcome = convert({"lab.csv", "--case", din_bob, "-o", "out.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "lab.csv:3: column \"torque_N_m\": \"much\" is not a number"))
        << outcome.err;
    EXPECT_EQ(text_of(folder / "out.csv"), "old");
    EXPECT_EQ(names_in(folder.path()), "lab.csv out.csv");
}

TEST_F(ConvertVerb, places_that_cannot_take_the_table_are_refused) {
    write_text(folder / "lab.csv", "angular_velocity_rad_s,torque_N_m\n1,2\n");
    fs::create_directory(folder / "folder");
    for (const std::string place : {"lab.csv", "folder", "no/such/out.csv", "/dev/null"}) {
        const Outcome outcome = convert({"lab.csv", "--case", din_bob, "-o", place});
        EXPECT_EQ(outcome.exit_code, 2) << place << ": " << outcome.err;
        EXPECT_TRUE(holds(outcome.err, place)) << outcome.err;
    }
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
    EXPECT_EQ(text_of(folder / "lab.csv"), "angular_velocity_rad_s,torque_N_m\n1,2\n");
}

TEST_F(ConvertVerb, a_full_disk_leaves_nothing_half_written) {
    const Outcome outcome =
        run({.arguments = {"convert", measured, "--case", measured_case, "-o", "out.csv"},
             .directory = folder.path(),
             .file_size_limit = 1000});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST_F(ConvertVerb, a_computed_end_factor_is_refused) {
    const Outcome outcome = convert({measured, "--case", measured_case, "--set",
                                     "conversion.end_factor=computed", "-o", "out.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "conversion.end_factor")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST_F(ConvertVerb, a_step_that_is_not_there_is_refused) {
    const Outcome outcome = convert({measured, "--case", measured_case, "--step", "3"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "plain table")) << outcome.err;
}

// Water in a ramp: the first rows are inertia, and without them no yield stress is left to see.
TEST_F(ConvertVerb, rows_with_lag_give_no_yield_stress) {
    const std::string water = cases + "single-gap-water.toml";
    ASSERT_EQ(searle({"run", water, "-o", "run", "--quiet"}, folder.path()).exit_code, 0);
    const Outcome outcome = convert({"run/rheogram.csv", "--case", water, "-o", "out.csv"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "rows carry lag")) << outcome.err;
    EXPECT_FALSE(holds(outcome.err, "yield stress")) << outcome.err;
    EXPECT_TRUE(holds(text_of(folder / "out.csv"), ",nan,nan,unknown,"));
}

TEST_F(ConvertVerb, results_beyond_double_precision_are_an_error_with_the_line) {
    write_text(folder / "lab.csv", "angular_velocity_rad_s,torque_N_m\n1,1e-3\n2,1e308\n");
    const Outcome outcome = convert({"lab.csv", "--case", din_bob, "-o", "out.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "line 3")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "lab.csv");
}

TEST_F(ConvertVerb, thousands_separators_are_refused) {
    write_text(folder / "lab.csv", "speed [rpm],torque [uN.m]\n\"1,000\",\"2,000\"\n");
    const Outcome outcome = convert({"lab.csv", "--case", din_bob});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "may mean 1000 or 1.000")) << outcome.err;
}

TEST_F(ConvertVerb, one_step_of_a_spreadsheet_is_chosen_by_number_or_name) {
    const fs::path file =
        fs::path(SEARLE_SOURCE_DIR) / ".." / "shared" / "data" / "din_cylinder_surfactant_15C.xls";
    if (!fs::exists(file))
        GTEST_SKIP() << file << " is not here: the measured sets are kept outside of the project";
    const Outcome by_number = convert({file.string(), "--case", din_bob, "--step", "3", "--quiet"});
    const Outcome by_name =
        convert({file.string(), "--case", din_bob, "--step", "Flow sweep - 3", "--quiet"});
    ASSERT_EQ(by_number.exit_code, 0) << by_number.err;
    EXPECT_EQ(by_number.out, by_name.out);
    EXPECT_EQ(std::count(by_number.out.begin(), by_number.out.end(), '\n'), 42);
    EXPECT_TRUE(holds(by_number.out, ",Flow sweep - 3,iso-3219,"));
}

} // namespace
