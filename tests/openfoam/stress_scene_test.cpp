#include "app/stress/scene_trial.hpp"
#include "solvers/openfoam/installation.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace searle::app {
namespace {

/// A steady scene through OpenFOAM is held to the flow law itself, and leaves no files.
TEST(OpenFoamStress, a_scene_is_held_to_the_truth_of_the_native_engine) {
    if (!solvers::openfoam::find_installation())
        GTEST_SKIP() << "OpenFOAM is not installed (package openfoam)";
    const auto scratch_folders = [] {
        int count = 0;
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
            count += entry.path().filename().string().starts_with("searle-stress-") ? 1 : 0;
        return count;
    };
    const int before = scratch_folders();
    const Trial trial = try_scene(
        {.kind = "by hand",
         .text = "[geometry]\ntype = \"box\"\ngap = \"1 mm\"\nlength = \"20 mm\"\nwidth = \"10 "
                 "mm\"\n[fluid]\nmodel = \"power-law\"\nconsistency = \"1 Pa.s^n\"\nflow_index = "
                 "0.7\ndensity = \"1000 kg/m^3\"\n[protocol]\ntype = \"steps\"\nshear_rates = "
                 "[\"10 1/s\"]\nhold = \"steady\"\n[solver]\naccuracy = 1e-2\nengine = "
                 "\"openfoam\"\n",
         .physical = true},
        600.0, {}); // half of it is the clock's, on a machine that may be busy
    EXPECT_EQ(trial.verdict, Verdict::right) << trial.reason;
    EXPECT_EQ(trial.truth, "50 digits");
    EXPECT_LE(trial.worst_ratio, 1.0);
    EXPECT_EQ(scratch_folders(), before);
}

} // namespace
} // namespace searle::app
