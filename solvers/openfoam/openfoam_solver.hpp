#pragma once

#include "solvers/openfoam/foam_plan.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <filesystem>

namespace searle::solvers::openfoam {

/// OpenFOAM ended without a single row. The program's exit code for it is 3.
struct OpenFoamFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// It ended by itself, with a fault that its log tells: a number beyond all bounds, for instance.
struct OpenFoamBlewUp : OpenFoamFailed {
    using OpenFoamFailed::OpenFoamFailed;
};

/// Largest relative imbalance of torques (LevelResult::imbalance) that passes for round-off and
/// discretisation; above it the result is reported as not reached.
inline constexpr double balance_limit = 2e-3;

/// Folder of a level's case within the engine's folder, 0 the coarsest.
[[nodiscard]] std::filesystem::path level_folder(const std::filesystem::path& engine_folder,
                                                 int level);

/// Writes the cases of the first two levels, without running them.
/// Throws std::filesystem::filesystem_error, geometry::MeshError.
void write_levels(const Scene& scene, const FoamPlan& plan,
                  const std::filesystem::path& engine_folder, const Installation& installation);

/// Runs levels of refinement until two of them agree to the asked accuracy. The error of a row is
/// the difference of the last two levels (for a scheme of second order three times what is left by
/// Richardson's estimate, the safety factor of Roache 1998 for two grids), what the torques'
/// balance lacks, chords, and the viscosity's cap.
/// @param engine_folder  holds one case a level; runs that stand there go on
[[nodiscard]] radial::RadialReport solve_with_openfoam(const Scene& scene, const Plan& plan,
                                                       const std::filesystem::path& engine_folder,
                                                       const Installation& installation,
                                                       const ProgressSink& progress);

/// The same from levels that were run elsewhere.
[[nodiscard]] radial::RadialReport collect_from_openfoam(const Scene& scene, const Plan& plan,
                                                         const std::filesystem::path& engine_folder,
                                                         const Installation& installation);

} // namespace searle::solvers::openfoam
