#pragma once

#include <filesystem>
#include <optional>

namespace searle::app {

struct CollectOptions {
    std::filesystem::path engine_folder;         ///< holds case.toml and level-*
    std::optional<std::filesystem::path> folder; ///< default: engine_folder without ".openfoam"
    bool quiet = false;
    bool replace = false; ///< --force
};

/// `searle collect DIR`: OpenFOAM cases that were run elsewhere become a result folder. Exit code:
/// done, or not_reached where the levels do not agree to the asked accuracy.
[[nodiscard]] int collect(const CollectOptions& options);

} // namespace searle::app
