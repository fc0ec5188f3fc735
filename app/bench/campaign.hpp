#pragma once

#include "app/bench/apart.hpp"
#include "app/bench/bench_scenes.hpp"
#include "app/bench/measurement.hpp"

#include <functional>
#include <string>
#include <vector>

namespace searle::app::bench {

/// What a campaign measures.
struct CampaignOptions {
    std::vector<BenchScene> scenes;
    bool quick{};      ///< fewer accuracies, cheap peers, coarser references, 55 s in all
    bool peers = true; ///< the other programs, where they are installed
    int repeats = 3;   ///< rounds, in each of which all settings of a scene take turns
};

/// @param tell  one line on what is being measured
/// The result holds what was finished when `stop` came to say so.
[[nodiscard]] BenchResult measure(const CampaignOptions& options,
                                  const std::function<void(const std::string&)>& tell,
                                  const StopQuestion& stop);

/// Processor, number of processors, and the load while measuring.
[[nodiscard]] std::string machine_text();

} // namespace searle::app::bench
