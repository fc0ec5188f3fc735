#include "laws/gap/eccentric_cylinders.hpp"
#include "running_cases.hpp"

#include <cmath>
#include <fmt/format.h>

// The eccentric bob, which only this engine has, against the exact creeping flow between eccentric
// cylinders.

namespace searle::app {
namespace {

using namespace testing;

/// Apparent over true viscosity of the case's only row, with its error bar.
struct Reading {
    double ratio{};
    double error{};
};

class OpenFoamEccentric : public OpenFoamRuns {
protected:
    /// The case of cases/ without its sweep, with two levels up to so many cells across the gap.
    Reading reading_at(const std::string& offset, int cells) {
        const std::string text =
            text_of(std::string(SEARLE_SOURCE_DIR) + "/cases/openfoam-eccentric.toml");
        write_text(folder / "one.toml", text.substr(0, text.find("[sweep]")));
        const std::string out = fmt::format("across-{}", cells);
        const Outcome outcome =
            run({.arguments = {"run", "one.toml", "-o", out, "--quiet", "--set",
                               "geometry.offset=" + offset, "--set", "solver.accuracy=0.1", "--set",
                               fmt::format("mesh.cells_across_gap={}", cells), "--set",
                               fmt::format("mesh.angular_cells={}", 12 * cells)},
                 .directory = folder.path()});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const rheometry::RheogramPoint point = rheogram_in(folder / out).points.at(0);
        return {point.viscosity, point.stress_error / point.shear_rate}; // the fluid has 1 Pa s
    }
};

TEST_F(OpenFoamEccentric, error_falls_with_the_square_of_the_cells_and_stays_within_its_bar) {
    const double exact = laws::gap::EccentricCylinders{14.0, 15.0, 0.5}.torque_ratio();
    double before = 0.0;
    for (const int cells : {10, 20, 40}) {
        const Reading reading = reading_at("0.5 mm", cells);
        const double error = std::abs(reading.ratio - exact);
        EXPECT_LT(error, reading.error) << cells;
        if (before > 0.0) {
            EXPECT_NEAR(std::log2(before / error), 2.0, 0.15) << cells;
        }
        before = error;
    }
    EXPECT_LT(before, 1e-3 * exact);
}

TEST_F(OpenFoamEccentric, a_bob_close_to_the_cup_is_right_within_its_bar) {
    const double exact = laws::gap::EccentricCylinders{14.0, 15.0, 0.75}.torque_ratio();
    const Reading reading = reading_at("0.75 mm", 20);
    EXPECT_LT(std::abs(reading.ratio - exact), reading.error);
    EXPECT_LT(reading.error, 0.02 * exact);
}

} // namespace
} // namespace searle::app
