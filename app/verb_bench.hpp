#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct BenchOptions {
    std::vector<std::string> names; ///< scenes or the beginnings of their names; empty: all
    bool quick{};
    std::filesystem::path folder = "bench-results";
    bool json{};
    bool readme{};
    bool no_peers{};
    bool list{};
    bool replace{};
    bool quiet{};
};

/// Measures run time against error, of this program and of its peers; what was measured is kept
/// when a signal ends it. Returns the exit code.
int bench_scenes_verb(const BenchOptions& options);

} // namespace searle::app
