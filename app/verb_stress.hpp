#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

struct StressOptions {
    std::vector<std::string> families; ///< empty: all but "openfoam"
    long scenes = 100;                 ///< of each family
    long first = 1;                    ///< number of the first
    std::int64_t seed = 1;
    double minutes = 0.0;              ///< 0: no limit
    double scene_seconds = 120.0;
    std::filesystem::path folder = "stress-results";
    bool json = false;
    bool quiet = false;
};

/// `searle stress`: seeded random scenes, each held to the truth in a process of its own. Exit codes:
/// done; program_fault where a scene was WRONG, CRASHED or HUNG; interrupted, with what was done
/// kept. The same command goes on from there. Throws UsageError for a family that there is not.
[[nodiscard]] int stress(const StressOptions& options);

} // namespace searle::app
