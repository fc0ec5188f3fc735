#pragma once

#include "app/bench/apart.hpp"
#include "app/bench/bench_scenes.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace searle::app::bench {

/// What a peer gave.
struct PeerRun {
    std::vector<double> torques{}; ///< as the scene's rows; empty where a peer has only a cost
    double cpu{};
    double unknowns{};
    double peak_MiB{};
    std::string fault{};
    std::string remark{};
};

/// Another program with a setting, on a scene.
struct Peer {
    std::string code{};
    std::string setting{};
    double cost{}; ///< CPU seconds that it takes, roughly; for the choice of --quick
    /// @param folder  empty, for its files
    std::function<PeerRun(const std::filesystem::path& folder, double limit,
                          const StopQuestion& stop)>
        run;
};

/// The peers that are installed, with their best settings known, for a scene; empty: none.
[[nodiscard]] std::vector<Peer> openfoam_peers(const BenchScene& scene);
[[nodiscard]] std::vector<Peer> particle_peers(const BenchScene& scene);

} // namespace searle::app::bench
