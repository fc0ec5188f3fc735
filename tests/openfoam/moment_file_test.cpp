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

TEST(LoadHistory, nothing_there_is_no_samples) {
    const TemporaryFolder folder;
    EXPECT_TRUE(load_history(folder / "none", LoadComponent::moment_z).empty());
}

} // namespace
} // namespace searle::solvers::openfoam
