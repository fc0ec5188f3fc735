#include "../app/running.hpp"
#include "solvers/openfoam/moment_file.hpp"

#include <gtest/gtest.h>

namespace searle::solvers::openfoam {
namespace {

using app::testing::TemporaryFolder;
using app::testing::write_text;

TEST(LoadHistory, a_restart_replaces_what_an_earlier_start_wrote_after_it) {
    const TemporaryFolder folder;
    const std::string head = "# Moment\n# CofR : (0 0 0)\n#\n";
    write_text(folder / "0/moment.dat", head + "0.5\t(1 2 -3)\t(0 0 0)\t(1 2 -3)\n"
                                               "1\t(1 2 -4)\t(0 0 0)\t(1 2 -4)\n"
                                               "1.5\t(1 2 -5)\t(0 0 0)\t(1 2 -5)\n");
    write_text(folder / "1/moment.dat", head + "1.5\t(1 2 -6e-1)\t(0 0 0)\t(1 2 -6)\n"
                                               "2\t(1 2 -7)\t(0 0 0)\t(1 2 -7)\n"
                                               "2.5\t(1 2 -8)\t(0 0"); // killed while writing
    const auto samples = load_history(folder.path(), LoadComponent::moment_z);
    ASSERT_EQ(samples.size(), 4u);
    EXPECT_DOUBLE_EQ(samples[1].value, -4.0);
    EXPECT_DOUBLE_EQ(samples[2].time, 1.5);
    EXPECT_DOUBLE_EQ(samples[2].value, -0.6);
    EXPECT_DOUBLE_EQ(samples[3].time, 2.0);
}

TEST(LoadHistory, folders_that_are_no_times_are_left_alone) {
    const TemporaryFolder folder;
    const std::string line = "0.5\t(1 2 -3)\t(0 0 0)\t(1 2 -3)\n";
    for (const char* name : {"nan", "inf", "-inf", "0", "0.orig", "constant"})
        write_text(folder / name / "moment.dat", line);
    EXPECT_EQ(load_history(folder.path(), LoadComponent::moment_z).size(), 1u);
}

TEST(LastLoads, are_the_end_of_a_long_file_and_all_of_a_short_one) {
    const TemporaryFolder folder;
    std::string text = "# Moment\n";
    const std::string other(200, '1'); // as long as OpenFOAM's lines are
    for (int time = 1; time <= 1000; ++time)
        text += std::to_string(time) + "\t(1 2 " + std::to_string(-time) + ")\t(0 0 " + other +
                ")\t(1 2 3)\n";
    write_text(folder / "0/moment.dat", text);
    const auto last = last_loads(folder.path(), "0", LoadComponent::moment_z, 100);
    ASSERT_GE(last.size(), 90u);
    EXPECT_LE(last.size(), 130u);
    EXPECT_EQ(last.back().time, 1000.0);
    EXPECT_EQ(last.back().value, -1000.0);
    EXPECT_EQ(last_loads(folder.path(), "0", LoadComponent::moment_z, 10'000).size(), 1000u);
    EXPECT_TRUE(last_loads(folder.path(), "7", LoadComponent::moment_z, 10).empty());
}

TEST(LoadHistory, nothing_there_is_no_samples) {
    const TemporaryFolder folder;
    EXPECT_TRUE(load_history(folder / "none", LoadComponent::moment_z).empty());
}

} // namespace
} // namespace searle::solvers::openfoam
