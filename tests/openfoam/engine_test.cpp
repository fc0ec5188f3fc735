#include "rheometry/end_effect.hpp"
#include "running_cases.hpp"

#include <cmath>
#include <tuple>

// The whole way through the installed OpenFOAM, on scenes whose answer is known. Skipped where it
// is not installed.

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using namespace testing;

class OpenFoamEngine : public OpenFoamRuns {
protected:
    const std::vector<std::string> coarse{"solver.engine=openfoam", "solver.accuracy=0.01",
                                          "protocol.points=10"};
};

TEST_F(OpenFoamEngine, water_ramp_lies_within_its_errors_of_the_exact_series) {
    const Outcome outcome = run_case("single-gap-water.toml", "water", coarse);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const rheometry::Rheogram rheogram = rheogram_in(folder / "water");
    ASSERT_EQ(rheogram.points.size(), 10u);
    // eta_app / eta at 35 s: series solution, 1.008559 (docs/radial.md).
    const rheometry::RheogramPoint& last = rheogram.points.back();
    const double error = std::abs(last.viscosity / 1.0016e-3 - 1.008559);
    EXPECT_LT(error, last.stress_error / last.shear_stress + 1e-6);
    EXPECT_LT(last.stress_error / last.shear_stress, 0.01);
}

TEST_F(OpenFoamEngine, error_bar_shrinks_with_the_square_of_the_cells) {
    // Two levels each: the claimed error is the last difference, of second order in cells and step.
    double before = 0.0;
    for (const int cells : {10, 20, 40}) {
        const std::string out = "cells" + std::to_string(cells);
        (void)run_case("box-water.toml", out,
                       {"solver.engine=openfoam", "protocol.points=8",
                        "mesh.cells_across_gap=" + std::to_string(cells),
                        "solver.time_step=" + std::to_string(4.0 / cells) + " s"});
        const rheometry::RheogramPoint point = rheogram_in(folder / out).points.front();
        // Exact: lag d^2/(3 nu) on the moving wall, and a start long gone by 4.4 s.
        const double time = 35.0 / 8.0;
        const double exact = 1.0 + 1e-6 / (3.0 * 1.0016e-3 / 998.2) / time;
        const double error = std::abs(point.viscosity / 1.0016e-3 - exact);
        EXPECT_LT(error, point.stress_error / point.shear_stress) << cells;
        if (before > 0.0) {
            EXPECT_GT(before / point.stress_error, 3.0) << cells;
        }
        before = point.stress_error;
    }
}

TEST_F(OpenFoamEngine, steady_slurry_agrees_with_quadrature) {
    const Outcome outcome = run_case("single-gap-slurry.toml", "slurry",
                                     {"solver.engine=openfoam", "solver.accuracy=0.02",
                                      "protocol.shear_rates=[\"10 1/s\", \"1000 1/s\"]",
                                      "fluid.yield_stress=5 Pa", "fluid.consistency=0.5 Pa.s^n",
                                      "fluid.flow_index=0.5", "conversion.definition=bob-wall"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // R 14/15 mm: exact bob stresses (quadrature, peers' table of Herschel-Bulkley flows).
    const double exact[] = {6.96519, 21.68992};
    const rheometry::Rheogram rheogram = rheogram_in(folder / "slurry");
    ASSERT_EQ(rheogram.points.size(), 2u);
    for (std::size_t row = 0; row < 2; ++row)
        EXPECT_NEAR(rheogram.points[row].shear_stress, exact[row],
                    rheogram.points[row].stress_error);
}

TEST_F(OpenFoamEngine, two_processes_give_the_torque_of_one) {
    ASSERT_EQ(run_case("single-gap-water.toml", "one", coarse).exit_code, 0);
    std::vector<std::string> two = coarse;
    two.emplace_back("solver.processors=2");
    const Outcome outcome = run_case("single-gap-water.toml", "two", two);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto one = rheogram_in(folder / "one").points;
    const auto other = rheogram_in(folder / "two").points;
    for (std::size_t row = 0; row < one.size(); ++row)
        EXPECT_NEAR(other[row].torque / one[row].torque, 1.0, 1e-6);
}

TEST_F(OpenFoamEngine, an_interrupted_run_goes_on_to_the_same_result) {
    std::vector<std::string> long_enough = coarse;
    long_enough.emplace_back("solver.time_step=10 ms");
    ASSERT_EQ(run_case("single-gap-water.toml", "whole", long_enough).exit_code, 0);
    std::vector<std::string> words{
        "run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml", "-o", "parts"};
    for (const std::string& setting : long_enough) {
        words.emplace_back("--set");
        words.push_back(setting);
    }
    const Outcome first = run({.arguments = words,
                               .directory = folder.path(),
                               .signal = SIGINT,
                               .signal_when = "searle:"});
    EXPECT_EQ(first.exit_code, 130) << first.err;
    fs::remove_all(folder / "parts");
    words.emplace_back("--quiet");
    const Outcome second = run({.arguments = words, .directory = folder.path()});
    ASSERT_EQ(second.exit_code, 0) << second.err;
    const auto whole = rheogram_in(folder / "whole").points;
    const auto parts = rheogram_in(folder / "parts").points;
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t row = 0; row < whole.size(); ++row)
        EXPECT_NEAR(parts[row].torque / whole[row].torque, 1.0, 1e-8);
}

TEST_F(OpenFoamEngine, written_cases_run_by_hand_and_are_collected) {
    std::vector<std::string> words{"run",
                                   std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                                   "--write-only", "-o", "water.openfoam"};
    for (const std::string& setting : coarse) {
        words.emplace_back("--set");
        words.push_back(setting);
    }
    ASSERT_EQ(run({.arguments = words, .directory = folder.path()}).exit_code, 0);
    EXPECT_EQ(names_in(folder / "water.openfoam"), "case.toml level-1 level-2");
    const Start collect{.arguments = {"collect", "water.openfoam"}, .directory = folder.path()};
    EXPECT_EQ(run(collect).exit_code, 3); // nothing was run yet
    EXPECT_FALSE(fs::exists(folder / "water"));
    setenv("WM_PROJECT_DIR", solvers::openfoam::find_installation()->project.c_str(), 1);
    for (const char* level : {"level-1", "level-2"})
        ASSERT_EQ(run({.directory = folder.path(),
                       .program = folder / (std::string("water.openfoam/") + level + "/Allrun")})
                      .exit_code,
                  0);
    const Outcome outcome = run(collect);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(rheogram_in(folder / "water").points.size(), 10u);
    EXPECT_EQ(text_of(folder / "water/summary.json").find("other versions"), std::string::npos);

    // A cluster has another version.
    const fs::path log = folder / "water.openfoam/level-2/log.pimpleFoam";
    std::string text = text_of(log);
    const std::size_t version = text.find("OPENFOAM=1912");
    ASSERT_NE(version, std::string::npos);
    write_text(log, text.replace(version, 13, "OPENFOAM=2206"));
    const Outcome other = run(
        {.arguments = {"collect", "water.openfoam", "-o", "again"}, .directory = folder.path()});
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_NE(other.err.find("OpenFOAM 2206 solved it"), std::string::npos) << other.err;
}

// A slice has all of its steady rows in one run: it goes on where it was stopped, and Allrun is one
// line.
TEST_F(OpenFoamEngine, steady_rows_of_a_slice_go_on_in_the_middle_of_one) {
    const std::vector<std::string> settings{
        "solver.engine=openfoam", "solver.accuracy=0.02", "mesh.cells_across_gap=4096",
        "protocol={type=\"steps\", shear_rates=[\"0.01 1/s\", \"100 1/s\", \"-0.01 1/s\"], "
        "hold=\"steady\"}"};
    ASSERT_EQ(run_case("single-gap-slurry.toml", "whole", settings).exit_code, 0);
    std::vector<std::string> words = words_for("single-gap-slurry.toml", "parts", settings);
    std::erase(words, "--quiet");
    const Start start{.arguments = words,
                      .directory = folder.path(),
                      .signal = SIGKILL,
                      .signal_when = "iteration "};
    EXPECT_NE(run(start).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder / "parts.openfoam/level-1"));
    ASSERT_EQ(run_case("single-gap-slurry.toml", "parts", settings).exit_code, 0);
    const auto whole = rheogram_in(folder / "whole").points;
    const auto parts = rheogram_in(folder / "parts").points;
    ASSERT_EQ(whole.size(), 3u);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t row = 0; row < whole.size(); ++row)
        EXPECT_NEAR(parts[row].torque, whole[row].torque, 1e-8 * whole[0].torque) << row;
    EXPECT_LT(whole[2].torque, 0.0);
}

// Killed within a row that is a run of its own, before that row wrote anything.
TEST_F(OpenFoamEngine, a_row_that_was_killed_is_run_again) {
    const std::vector<std::string> settings{
        "solver.engine=openfoam", "solver.application=simpleFoam", "solver.accuracy=0.01",
        "mesh.cells_across_gap=480",
        "protocol={type=\"steps\", shear_rates=[\"1 1/s\", \"3 1/s\"], hold=\"steady\"}"};
    ASSERT_EQ(run_case("single-gap-water.toml", "whole", settings).exit_code, 0);
    std::vector<std::string> words = words_for("single-gap-water.toml", "parts", settings);
    std::erase(words, "--quiet");
    const Outcome killed = run({.arguments = words,
                                .directory = folder.path(),
                                .signal = SIGKILL,
                                .signal_when = "iteration"});
    EXPECT_NE(killed.exit_code, 0);
    ASSERT_EQ(run_case("single-gap-water.toml", "parts", settings).exit_code, 0);
    const auto whole = rheogram_in(folder / "whole").points;
    const auto parts = rheogram_in(folder / "parts").points;
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t row = 0; row < whole.size(); ++row)
        EXPECT_NEAR(parts[row].torque / whole[row].torque, 1.0, 1e-8) << row;
}

// With residuals asked for that round-off does not let happen, only the watch ends a row.
TEST_F(OpenFoamEngine, rows_run_by_hand_end_when_their_torque_stands_still) {
    std::vector<std::string> words = words_for(
        "single-gap-water.toml", "water.openfoam",
        {"solver.engine=openfoam", "solver.application=simpleFoam", "solver.accuracy=0.01",
         "mesh.cells_across_gap=80",
         "protocol={type=\"steps\", shear_rates=[\"1 1/s\", \"3 1/s\"], hold=\"steady\"}"});
    words.insert(words.begin() + 1, "--write-only");
    const Outcome written = run({.arguments = words, .directory = folder.path()});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    setenv("WM_PROJECT_DIR", solvers::openfoam::find_installation()->project.c_str(), 1);
    for (const char* level : {"level-1", "level-2"}) {
        const fs::path place = folder / "water.openfoam" / level;
        std::string solution = text_of(place / "system/fvSolution");
        const std::size_t limit = solution.find("1e-07;");
        ASSERT_NE(limit, std::string::npos);
        write_text(place / "system/fvSolution", solution.replace(limit, 6, "1e-60;"));
        const Outcome outcome = run({.directory = folder.path(), .program = place / "Allrun"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        // Rows of the second level start from what the first found, an iteration later.
        const int late = level == std::string("level-2") ? 1 : 0;
        for (const int row_start : {0, 10'000}) {
            const std::string start = std::to_string(row_start + late);
            const std::string torques =
                text_of(place / "postProcessing/torque_bob" / start / "moment.dat");
            const auto lines = std::ranges::count(torques, '\n');
            EXPECT_GE(lines, 1000) << level << ' ' << start;
            EXPECT_LT(lines, 10'000) << level << ' ' << start;
        }
    }
    const Outcome outcome =
        run({.arguments = {"collect", "water.openfoam"}, .directory = folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto rows = rheogram_in(folder / "water").points;
    ASSERT_EQ(rows.size(), 2u);
    // Water in a gap below the onset of vortices reads its own viscosity.
    for (const auto& row : rows)
        EXPECT_NEAR(row.viscosity, 1.0016e-3, row.stress_error / std::abs(row.shear_rate));
}

TEST_F(OpenFoamEngine, the_defective_program_is_told_by_its_torques) {
    const Outcome outcome =
        run_case("single-gap-slurry.toml", "defect",
                 {"solver.engine=openfoam", "solver.application=nonNewtonianIcoFoam",
                  "protocol={type=\"ramp\", from=\"0 1/s\", to=\"100 1/s\", duration=\"2 s\", "
                  "points=4}"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_NE(text_of(folder / "defect/summary.json").find("nonNewtonianIcoFoam"),
              std::string::npos);
    EXPECT_NE(text_of(folder / "defect/summary.json").find("known defect"), std::string::npos);
}

// Instruments with ends = true, whose c_L the native engine knows to 1e-4: the mesh has the ends,
// too.
TEST_F(OpenFoamEngine, ends_of_gaps_have_the_c_L_of_the_native_engine) {
    const std::string rest = "\nends = true\nbottom_gap = \"5 mm\"\n\n[fluid]\nmodel = "
                             "\"newtonian\"\nviscosity = \"1 Pa.s\"\ndensity = \"1000 kg/m^3\"\n\n"
                             "[protocol]\ntype = \"steps\"\nshear_rates = [\"1 1/s\"]\nhold = "
                             "\"steady\"\n\n[solver]\naccuracy = 0.02\n\n[mesh]\n"
                             "cells_across_gap = 6\n";
    for (const auto& [name, geometry] :
         {std::pair{"single", "type = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = "
                              "\"16 mm\"\nheight = \"20 mm\""},
          std::pair{"double", "type = \"double-gap\"\nradii = [\"20 mm\", \"21 mm\", \"22 mm\", "
                              "\"23 mm\"]\nheight = \"20 mm\""}}) {
        write_text(folder / (std::string(name) + ".toml"),
                   std::string("[geometry]\n") + geometry + rest);
        const auto end_factor = [&](const std::string& engine) {
            const std::string out = std::string(name) + "-" + engine;
            const Outcome outcome =
                run({.arguments = {"run", std::string(name) + ".toml", "-o", out, "--quiet",
                                   "--set", "solver.engine=" + engine},
                     .directory = folder.path()});
            EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
            return rheometry::read_end_effect_csv(folder / out / "end_factor.csv").at(0);
        };
        const auto native = end_factor("native");
        const auto openfoam = end_factor("openfoam");
        EXPECT_GT(native.end_factor, 1.02) << name;
        EXPECT_NEAR(openfoam.end_factor, native.end_factor, openfoam.error + native.error) << name;
        EXPECT_LT(openfoam.error, 0.02 * openfoam.end_factor) << name;
    }
}

TEST_F(OpenFoamEngine, c_L_of_a_din_bob_agrees_with_the_native_engine_in_a_wedge_and_in_3d) {
    const std::string text =
        text_of(std::string(SEARLE_SOURCE_DIR) + "/cases/openfoam-din-bob.toml");
    write_text(folder / "bob.toml", text.substr(0, text.find("[[sweep.runs]]")));
    for (const auto& [out, angle, cells] :
         {std::tuple{"wedge", "1 deg", "1"}, std::tuple{"sector", "90 deg", "9"}}) {
        const Outcome outcome =
            run({.arguments = {"run", "bob.toml", "-o", out, "--quiet", "--set",
                               "mesh.cells_across_gap=6", "--set", "solver.accuracy=0.02", "--set",
                               std::string("mesh.wedge_angle=") + angle, "--set",
                               std::string("mesh.angular_cells=") + cells},
                 .directory = folder.path()});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        // Creeping c_L of the standard geometry, 1.08868 (independent finite elements).
        const auto ends = rheometry::read_end_effect_csv(folder / out / "end_factor.csv");
        ASSERT_EQ(ends.size(), 1u);
        EXPECT_NEAR(ends[0].end_factor, 1.08868, ends[0].error) << out;
        EXPECT_LT(ends[0].error, 0.02);
        // Converted with its own c_L a row reads the oil's 1 Pa s.
        EXPECT_NEAR(rheogram_in(folder / out).points.at(0).viscosity, 1.0, 1e-9);
    }
}

TEST_F(OpenFoamEngine, a_row_whose_torque_stands_still_ends_though_a_residual_hangs) {
    write_text(folder / "ends.toml", R"([geometry]
type = "single-gap"
bob_radius = "14 mm"
cup_radius = "15 mm"
height = "42 mm"
ends = true
bottom_gap = "5 mm"
[fluid]
model = "newtonian"
viscosity = "1 Pa.s"
density = "1000 kg/m^3"
[protocol]
type = "steps"
shear_rates = ["10 1/s"]
hold = "steady"
[solver]
engine = "openfoam"
accuracy = "2 %"
secondary_flow = true
[mesh]
cells_across_gap = 20
)");
    const Outcome outcome = run(
        {.arguments = {"run", "ends.toml", "-o", "ends", "--quiet"}, .directory = folder.path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // One of the secondary flow's residuals, which is a part in 1e8 of the swirl, never falls.
    const std::string log = text_of(folder / "ends.openfoam/level-2/log.simpleFoam");
    EXPECT_NE(log.find("\nTime = 100\n"), std::string::npos);
    EXPECT_EQ(log.find("\nTime = 5000\n"), std::string::npos);
}

TEST_F(OpenFoamEngine, a_case_changed_by_hand_is_not_gone_on_with) {
    ASSERT_EQ(run_case("single-gap-water.toml", "water", coarse).exit_code, 0);
    fs::remove_all(folder / "water");
    const fs::path file = folder / "water.openfoam/level-1/constant/transportProperties";
    write_text(file, text_of(file) + "\n// thicker\n");
    const Outcome outcome = run_case("single-gap-water.toml", "water", coarse);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("transportProperties"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "water"));
}

TEST_F(OpenFoamEngine, engines_are_compared_side_by_side) {
    const Outcome outcome = run(
        {.arguments = {"compare", std::string(SEARLE_SOURCE_DIR) + "/cases/box-water.toml", "--set",
                       "solver.accuracy=0.01", "--set", "protocol.points=5", "-o", "two"},
         .directory = folder.path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("5 of 5 rows within both errors"), std::string::npos) << outcome.out;
    EXPECT_EQ(names_in(folder / "two"),
              "comparison.csv native openfoam report.html rheograms.csv summary.json");
    EXPECT_NE(text_of(folder / "two/report.html").find("Difference of the engines"),
              std::string::npos);
    EXPECT_NE(text_of(folder / "two/summary.json").find("5 of 5 rows of openfoam lie within"),
              std::string::npos);
}

TEST(OpenFoamMissing, its_absence_names_the_package_and_writes_nothing) {
    const TemporaryFolder folder;
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const Outcome outcome =
        run({.arguments = {"run", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", "solver.engine=openfoam", "-o", "water"},
             .directory = folder.path()});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("apt-get install openfoam"), std::string::npos) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST(OpenFoamSettings, what_only_it_has_is_refused_with_the_native_engine) {
    for (const char* setting : {"solver.processors=2", "solver.application=pimpleFoam",
                                "solver.time_step=1 ms", "solver.viscosity_cap=10 Pa.s"}) {
        const Outcome outcome = run(
            {.arguments = {"check", std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml",
                           "--set", setting}});
        EXPECT_EQ(outcome.exit_code, 2) << setting;
        EXPECT_NE(outcome.err.find("engine"), std::string::npos) << outcome.err;
    }
}

} // namespace
} // namespace searle::app
