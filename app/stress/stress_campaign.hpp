#pragma once

#include "app/stress/scene_trial.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace searle::app {

struct StressPlan {
    std::vector<std::string> families;
    long first = 1; ///< number of the first scene
    long scenes{};  ///< of each family
    std::uint64_t seed{};
    double minutes{};     ///< of wall clock over all; 0: no limit
    double scene_limit{}; ///< s of a scene
    std::filesystem::path folder;
};

/// How many scenes came to which verdict.
struct Tally {
    std::map<Verdict, long> count;
    /// Scenes in which no row lies past the onset of Taylor vortices (hung and crashed ones tell
    /// nothing and count here), and those of them that came out right.
    long below_onset{};
    long right_below_onset{};
    double cpu{};
    [[nodiscard]] long total() const;
    [[nodiscard]] long failures() const;
};

struct StressResult {
    std::map<std::string, Tally> families;                     ///< by family
    std::map<std::string, std::map<std::string, Tally>> kinds; ///< by family and kind
    std::vector<std::string> failures; ///< "fluid-17: WRONG, 1.3 error bars from ..."
    bool stopped{};                    ///< by a signal or by the time
};

/// Runs the scenes in the order of their numbers. `folder`/stress.csv gets a line a scene as it
/// goes (family, number, seed, kind, verdict, ratio, claimed error, CPU, truth, reason, Re over
/// that at the onset of Taylor vortices); scenes of the same seed that stand there already are
/// taken from there. The case of each failure is written to `folder`/failures/FAMILY-NUMBER.toml,
/// that of a scene that gave up to `folder`/gave-up/.
/// @param told  called after each scene: how many are done of how many, and the failures so far
[[nodiscard]] StressResult run_stress(const StressPlan& plan, const bench::StopQuestion& stop,
                                      const std::function<void(long, long, long)>& told);

/// Tables by family and by kind, and the failures.
[[nodiscard]] std::string stress_text(const StressResult& result);
[[nodiscard]] std::string stress_json(const StressResult& result);

} // namespace searle::app
