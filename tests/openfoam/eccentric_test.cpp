#include "laws/gap/eccentric_cylinders.hpp"
#include "running_cases.hpp"

#include <cmath>
#include <fmt/format.h>

// The eccentric bob, which only this engine has, against the exact creeping flow between eccentric
// cylinders.

namespace searle::app {
namespace {

using namespace testing;

class OpenFoamEccentric : public OpenFoamRuns {
protected:
    /// The case of cases/ without its sweep.
    std::string one_case() {
        const std::string text =
            text_of(std::string(SEARLE_SOURCE_DIR) + "/cases/openfoam-eccentric.toml");
        write_text(folder / "one.toml", text.substr(0, text.find("[sweep]")));
        return (folder / "one.toml").string();
    }
};

/// Apparent over true viscosity of the case's only row, with its error bar.
struct Reading {
    double ratio{};
    double error{};
};

Reading reading_in(const std::filesystem::path& folder) {
    const rheometry::RheogramPoint point = rheogram_in(folder).points.at(0);
    return {point.viscosity, point.stress_error / point.shear_rate}; // the fluid has 1 Pa s
}

TEST_F(OpenFoamEccentric, error_falls_with_the_square_of_the_cells_and_stays_within_its_bar) {
    for (const double offset : {0.5, 0.75}) { // mm of a gap of 1 mm
        const double exact = laws::gap::EccentricCylinders{14.0, 15.0, offset}.torque_ratio();
        double before = 0.0;
        for (const int cells : {10, 20, 40}) {
            const std::string out = fmt::format("at{}-{}", offset, cells);
            const Outcome outcome =
                run({.arguments = {"run", one_case(), "-o", out, "--quiet", "--set",
                                   fmt::format("geometry.offset={} mm", offset), "--set",
                                   "solver.accuracy=0.1", "--set",
                                   fmt::format("mesh.cells_across_gap={}", cells), "--set",
                                   fmt::format("mesh.angular_cells={}", 12 * cells)},
                     .directory = folder.path()});
            // The torques of so coarse a mesh may differ by more than the 0.2 % that pass.
            if (cells > 10) {
                ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            }
            const Reading reading = reading_in(folder / out);
            const double error = std::abs(reading.ratio - exact);
            EXPECT_LT(error, reading.error) << out;
            if (before > 0.0) {
                EXPECT_NEAR(std::log2(before / error), 2.0, 0.15) << out;
            }
            before = error;
        }
        EXPECT_LT(before, 2e-3 * exact);
    }
}

} // namespace
} // namespace searle::app
