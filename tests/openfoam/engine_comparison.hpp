#pragma once

#include "running_cases.hpp"

#include <cmath>
#include <utility>

namespace searle::app::testing {

inline const std::string water = "model = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"\ndensity = "
                                 "\"998.2 kg/m^3\"\n";
// A time step is thousands of the cells' diffusion times.
inline const std::string oil =
    "model = \"newtonian\"\nviscosity = \"0.1 Pa.s\"\ndensity = \"900 kg/m^3\"\n";
inline const std::string slurry =
    "model = \"herschel-bulkley\"\nyield_stress = \"5 Pa\"\nconsistency = "
    "\"0.5 Pa.s^n\"\nflow_index = 0.5\ndensity = \"1000 kg/m^3\"\n";
inline const std::string single_gap =
    "type = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 "
    "mm\"\nheight = \"42 mm\"\n";
inline const std::string din_bob =
    "type = \"din-bob\"\nbob_radius = \"14 mm\"\ncup_radius = \"15.2 "
    "mm\"\n";

/// Both engines side by side. Skipped where OpenFOAM is not installed.
class EngineComparison : public OpenFoamRuns {
protected:
    /// Rows of both engines, which must agree within the sum of their errors.
    /// @param exit_code  of OpenFOAM's run
    /// @return the largest error that OpenFOAM's rows claim, over their stress
    double compare(const std::string& geometry, const std::string& fluid,
                   const std::string& protocol, const std::string& rest, int exit_code = 0) {
        // A double gap has a definition of its own.
        const std::string conversion = geometry.find("double-gap") == std::string::npos
                                           ? "[conversion]\ndefinition = \"bob-wall\"\n"
                                           : "";
        const std::string scene = "[geometry]\n" + geometry + "[fluid]\n" + fluid + "[protocol]\n" +
                                  protocol + conversion;
        write_text(folder / "case.toml", scene + rest);
        const auto rows_of = [&](const std::string& engine, const std::string& out) {
            std::vector<std::string> words{
                "run",     "case.toml", "-o",    out,
                "--quiet", "--force",   "--set", "solver.engine=" + engine};
            if (engine == "native")
                words.insert(words.end(), {"--set", "solver.accuracy=1e-4"});
            const Outcome outcome = run({.arguments = words, .directory = folder.path()});
            EXPECT_EQ(outcome.exit_code, engine == "native" ? 0 : exit_code) << outcome.err;
            return rheogram_in(folder / out).points;
        };
        const auto openfoam = rows_of("openfoam", "openfoam");
        write_text(folder / "case.toml", scene);
        const auto native = rows_of("native", "native");
        EXPECT_EQ(openfoam.size(), native.size());
        double largest = 0.0;
        for (std::size_t row = 0; row < std::min(openfoam.size(), native.size()); ++row) {
            const double claimed = openfoam[row].stress_error + native[row].stress_error;
            EXPECT_NEAR(openfoam[row].shear_stress, native[row].shear_stress, claimed) << row;
            largest = std::max(largest, openfoam[row].stress_error / openfoam[row].shear_stress);
        }
        return largest;
    }
};

} // namespace searle::app::testing
