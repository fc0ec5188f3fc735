#include "running_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sys/mount.h>

// What goes wrong around a run: a program that is missing, no room on the disk, numbers that grow
// without bounds.

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using namespace testing;

/// PATH has nothing but an empty `pimpleFoam`, WM_PROJECT_DIR what makes it look like OpenFOAM.
class LookAlike {
public:
    explicit LookAlike(std::string_view version = solvers::openfoam::supported_version) {
        const fs::path program = folder_ / "bin/pimpleFoam";
        write_text(program, "#!/bin/sh\n");
        fs::permissions(program, fs::perms::owner_all);
        write_text(folder_ / "etc/controlDict", "\n");
        write_text(folder_ / "etc/bashrc", fmt::format("export WM_PROJECT_VERSION={}\n", version));
        setenv("PATH", (folder_ / "bin").c_str(), 1);
        setenv("WM_PROJECT_DIR", folder_.path().c_str(), 1);
    }
    ~LookAlike() {
        setenv("PATH", path_.c_str(), 1);
        if (project_)
            setenv("WM_PROJECT_DIR", project_->c_str(), 1);
        else
            unsetenv("WM_PROJECT_DIR");
    }
    LookAlike(const LookAlike&) = delete;
    LookAlike& operator=(const LookAlike&) = delete;

private:
    TemporaryFolder folder_;
    std::string path_ = std::getenv("PATH");
    std::optional<std::string> project_ = std::getenv("WM_PROJECT_DIR") == nullptr
                                              ? std::nullopt
                                              : std::optional(std::getenv("WM_PROJECT_DIR"));
};

TEST(OpenFoamFaults, several_processes_without_mpirun_name_its_package_and_write_nothing) {
    const TemporaryFolder folder;
    const LookAlike only_openfoam;
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", "solver.engine=openfoam", "--set", "solver.processors=2", "-o",
                           "water"},
             .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("mpirun"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("apt-get install openmpi-bin"), std::string::npos) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST(OpenFoamFaults, a_program_that_does_nothing_and_says_all_is_well_is_no_result) {
    const TemporaryFolder folder;
    const LookAlike only_openfoam;
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", "solver.engine=openfoam", "-o", "water"},
             .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find("its torques stop after row 0 of 100"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.err.find("v1912"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "water"));
}

TEST(OpenFoamFaults, another_version_is_told_with_what_went_wrong) {
    const TemporaryFolder folder;
    const LookAlike other("v2306");
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", "solver.engine=openfoam", "-o", "water"},
             .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find("OpenFOAM v2306 is here"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("written for v1912"), std::string::npos) << outcome.err;
}

TEST(OpenFoamFaults, a_mesh_that_there_is_not_leaves_no_folder_behind) {
    const TemporaryFolder folder;
    const LookAlike only_openfoam;
    const std::vector<std::string> words{
        "run",   std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
        "--set", "solver.engine=openfoam",
        "--set", "geometry.offset=0.5 mm",
        "--set", "mesh.wedge_angle=90 deg"};
    for (const bool write_only : {false, true}) {
        std::vector<std::string> all = words;
        if (write_only)
            all.emplace_back("--write-only");
        const Outcome outcome = run({.arguments = all, .directory = folder.path()});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.err.find("geometry.offset"), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(folder / "results/single-gap-water.openfoam"));
    }
}

TEST(OpenFoamFaults, a_path_with_a_blank_is_refused_for_openfoam_cannot_run_there) {
    const TemporaryFolder folder;
    const LookAlike only_openfoam;
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", "solver.engine=openfoam", "-o", "my results"},
             .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("blank"), std::string::npos) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

/// A file system of so many kilobytes, unmounted at the end.
class SmallDisk {
public:
    explicit SmallDisk(int kilobytes) {
        is_there_ =
            mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, size(kilobytes).c_str()) == 0;
    }
    ~SmallDisk() {
        if (is_there_)
            umount2(folder_.path().c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    [[nodiscard]] bool is_there() const { return is_there_; }
    [[nodiscard]] const fs::path& path() const { return folder_.path(); }
    void grow_to(int kilobytes) const {
        mount("tmpfs", folder_.path().c_str(), "tmpfs", MS_REMOUNT, size(kilobytes).c_str());
    }

private:
    static std::string size(int kilobytes) { return "size=" + std::to_string(kilobytes) + "k"; }

    TemporaryFolder folder_;
    bool is_there_ = false;
};

class OpenFoamDisk : public OpenFoamRuns {};

TEST_F(OpenFoamDisk, a_full_disk_is_named_and_with_room_the_same_command_goes_on) {
    const SmallDisk disk(1024);
    if (!disk.is_there())
        GTEST_SKIP() << "only the superuser can mount a small disk";
    const std::vector<std::string> settings{"solver.engine=openfoam", "solver.accuracy=0.01",
                                            "protocol.points=100"};
    const Start start{.arguments = words_for("single-gap-water.toml", "water", settings),
                      .directory = disk.path()};
    const Outcome full = run(start);
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.err.find("the disk is full"), std::string::npos) << full.err;
    EXPECT_EQ(names_in(disk.path()), "water.openfoam");
    disk.grow_to(64 * 1024);
    const Outcome second = run(start);
    ASSERT_EQ(second.exit_code, 0) << second.err;
    ASSERT_EQ(run_case("single-gap-water.toml", "whole", settings).exit_code, 0);
    const auto parts = rheogram_in(disk.path() / "water").points;
    const auto whole = rheogram_in(folder / "whole").points;
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t row = 0; row < whole.size(); ++row)
        EXPECT_NEAR(parts[row].torque / whole[row].torque, 1.0, 1e-8);
}

class OpenFoamBlowUp : public OpenFoamRuns {};

TEST_F(OpenFoamBlowUp, leaves_no_rows_whose_error_nothing_bounds) {
    // The paper's program and step, a hundred of the cells' diffusion times.
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/openfoam-box.toml", "-o",
                           "box"},
             .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("icoFoam-1ms"), std::string::npos) << outcome.err;
    for (const char* run : {"8-cells", "32-cells", "icoFoam-1ms", "500um-gap"}) {
        if (!fs::exists(folder / "box" / run))
            continue;
        for (const auto& point : rheogram_in(folder / "box" / run).points)
            EXPECT_LT(point.stress_error, 0.5 * std::abs(point.shear_stress)) << run;
    }
    EXPECT_TRUE(fs::exists(folder / "box/8-cells/rheogram.csv"));
}

class OpenFoamComparison : public OpenFoamRuns {};

TEST_F(OpenFoamComparison, a_sweep_is_compared_case_by_case) {
    const fs::path file = folder / "gaps.toml";
    write_text(file, text_of(std::string(SEARLE_SOURCE_DIR) + "/cases/box-water.toml") +
                         "\n[sweep]\nvary = { \"geometry.gap\" = [\"1 mm\", \"0.5 mm\"] }\n");
    const Outcome outcome =
        run({.arguments = {"compare", file.string(), "--set", "solver.accuracy=0.01", "--set",
                           "protocol.points=5", "-o", "two"},
             .directory = folder.path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string agreement = "5 of 5 rows within both errors";
    const std::size_t first = outcome.out.find(agreement);
    ASSERT_NE(first, std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(agreement, first + 1), std::string::npos) << outcome.out;
    const std::string table = text_of(folder / "two/comparison.csv");
    EXPECT_TRUE(table.starts_with("case,row,time_s,shear_rate_1_s,native_stress_Pa,")) << table;
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 11);
}

} // namespace
} // namespace searle::app
