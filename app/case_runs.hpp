#pragma once

#include "app/solved_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

/// Where runs stand, and what becomes of what an earlier one left there.
struct RunPlace {
    std::filesystem::path folder; ///< the result folder
    bool replace = false;         ///< start anew rather than go on
    bool quiet = false;
};

struct SolvedRuns {
    std::vector<SolvedCase> solved; ///< those with a finished row, in order
    std::vector<std::string>
        failures; ///< of runs that OpenFOAM ended without a row, a sentence each
    /// After an interruption: the checkpoints that the same command goes on from.
    std::vector<std::filesystem::path> checkpoints;
};

/// Solves case after case until one was interrupted. Each is kept safe beside the result folder: a
/// suspension in a checkpoint, OpenFOAM's cases in the engine's folder. One that fails lets the
/// others go on; a single case throws OpenFoamFailed.
[[nodiscard]] SolvedRuns solve_all(std::vector<PlannedCase> planned, const RunPlace& place);

/// The results are written: what kept the finished runs safe goes. OpenFOAM's cases stay, to be
/// looked at.
void remove_checkpoints(const std::vector<SolvedCase>& solved, const RunPlace& place, bool sweeps);

} // namespace searle::app
