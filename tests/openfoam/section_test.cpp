#include "engine_comparison.hpp"

#include "laws/gap/eccentric_cylinders.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/openfoam/moment_file.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

// Flow around a bob's ends and off the axis, through the installed OpenFOAM: the swirl alone where
// the secondary flow is weak, rows that start from the level before, thick fluids in time.

namespace searle::app {
namespace {

using namespace testing;

class OpenFoamSection : public EngineComparison {
protected:
    /// The torque that a row's last iteration left on the bob, a wedge's, N m.
    double last_torque(const std::string& level) { return std::abs(loads(level).back().value); }
    std::vector<solvers::openfoam::LoadSample> loads(const std::string& level) {
        return solvers::openfoam::load_history(folder / level / "postProcessing/torque_bob",
                                               solvers::openfoam::LoadComponent::moment_z);
    }
    void write_water_row() {
        write_text(folder / "water.toml", "[geometry]\n" + din_bob + "[fluid]\n" + water +
                                              "[protocol]\ntype = \"steps\"\nangular_velocities "
                                              "= [\"0.7504 rad/s\"]\n[solver]\nengine = "
                                              "\"openfoam\"\naccuracy = 0.02\n");
    }
};

const std::string at_10_per_second = "type = \"steps\"\nshear_rates = [\"10 1/s\"]\n";

TEST_F(OpenFoamSection, creeping_flow_around_a_bob_is_the_swirl_alone_and_converges) {
    EXPECT_LT(compare(din_bob, oil, at_10_per_second, "[solver]\naccuracy = 0.001\n"), 0.001);
    EXPECT_NE(text_of(folder / "openfoam/summary.json").find("swirl alone"), std::string::npos);
    // At the bob's upper edge, 270 degrees of fluid, the swirl goes as distance^(2/3): uniform
    // cells have the torque to the order of 4/3, cells graded to the edge to more, at most 2.
    const double coarse = last_torque("openfoam.openfoam/level-1");
    const double middle = last_torque("openfoam.openfoam/level-2");
    const double fine = last_torque("openfoam.openfoam/level-3");
    const double order = std::log2((middle - coarse) / (fine - middle));
    EXPECT_GT(order, 4.0 / 3.0);
    EXPECT_LT(order, 2.0);
}

TEST_F(OpenFoamSection, a_slurry_around_a_bob_is_right_within_its_bar) {
    EXPECT_LT(compare(din_bob, slurry, at_10_per_second, "[solver]\naccuracy = 0.03\n"), 0.03);
}

TEST_F(OpenFoamSection, water_with_secondary_flow_starts_from_the_level_before) {
    write_water_row();
    const Outcome outcome = run(
        {.arguments = {"run", "water.toml", "-o", "water", "--quiet"}, .directory = folder.path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto row = rheogram_in(folder / "water").points.at(0);
    // The native engine's at 1e-4: 1.10749 times the endless bob's (tests/solvers).
    EXPECT_NEAR(row.torque, 5.6775e-7, 5.6775e-7 * row.stress_error / row.shear_stress);
    // From rest it takes as many iterations on every mesh.
    const auto first = loads("water.openfoam/level-1").size();
    const auto second = loads("water.openfoam/level-2").size();
    EXPECT_LT(2 * second, first);
    EXPECT_FALSE(std::filesystem::exists(folder / "water.openfoam/level-2/1"));
}

TEST_F(OpenFoamSection, rows_run_by_hand_start_from_the_level_before_as_well) {
    write_water_row();
    const Outcome whole = run(
        {.arguments = {"run", "water.toml", "-o", "water", "--quiet"}, .directory = folder.path()});
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    const Outcome written =
        run({.arguments = {"run", "water.toml", "-o", "hand", "--quiet", "--write-only"},
             .directory = folder.path()});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    setenv("WM_PROJECT_DIR", solvers::openfoam::find_installation()->project.c_str(), 1);
    for (const char* level : {"level-1", "level-2"}) {
        const Outcome outcome =
            run({.directory = folder.path(), .program = folder / "hand" / level / "Allrun"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const double by_hand = last_torque(std::string("hand/") + level);
        EXPECT_NEAR(by_hand / last_torque(std::string("water.openfoam/") + level), 1.0, 1e-12);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "hand/level-2/1"));
}

TEST_F(OpenFoamSection, a_thick_fluid_in_time_is_followed_around_a_bob_off_its_axis) {
    write_text(folder / "off.toml",
               "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 "
               "mm\"\nheight = \"42 mm\"\noffset = \"0.3 mm\"\n[fluid]\n" +
                   oil +
                   "[protocol]\ntype = \"ramp\"\nfrom = \"0 1/s\"\nto = \"20 1/s\"\nduration = "
                   "\"1 s\"\npoints = 5\n[conversion]\ndefinition = \"bob-wall\"\n[solver]\n"
                   "engine = \"openfoam\"\naccuracy = 0.03\n");
    const Outcome outcome =
        run({.arguments = {"run", "off.toml", "-o", "off", "--quiet"}, .directory = folder.path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(text_of(folder / "off/summary.json").find("pimpleFoam"), std::string::npos);
    const auto rows = rheogram_in(folder / "off").points;
    ASSERT_EQ(rows.size(), 5u);
    // The exact creeping flow; what inertia adds to a ramp of 1 s at its end is below the gap's
    // h^2 / nu = 9 ms over that.
    const double exact = laws::gap::EccentricCylinders{14.0, 15.0, 0.3}.torque_ratio();
    const double lag = 0.009;
    const auto& last = rows.back();
    EXPECT_NEAR(last.viscosity, 0.1 * exact,
                last.stress_error / last.shear_rate + 0.1 * exact * lag);
}

} // namespace
} // namespace searle::app
