#pragma once

#include "app/bench/apart.hpp"
#include "app/stress/random_case.hpp"

#include <string>
#include <string_view>

namespace searle::app {

/// What became of a scene. The last three are failures of the program.
enum class Verdict {
    right,   ///< every row lies within its error bar of the truth
    gave_up, ///< the accuracy was not reached, it says why, and its larger bars hold
    refused, ///< with a reason, before solving
    wrong,   ///< a row lies outside of its bar
    crashed, ///< a signal, an exception that is no message to the user, a number that is none
    hung     ///< the time limit
};

[[nodiscard]] std::string_view name_of(Verdict verdict);
[[nodiscard]] bool is_failure(Verdict verdict);

struct Trial {
    Verdict verdict = Verdict::crashed;
    double worst_ratio{};    ///< largest distance from the truth over the error bar(s)
    double relative_error{}; ///< largest claimed, relative to the stress
    double cpu{};            ///< s, the truth's cost included
    /// Largest Re over its value at the onset of Taylor vortices; 0 without any, or where the scene
    /// told nothing.
    double taylor_ratio{};
    std::string truth;  ///< what it was held to
    std::string reason; ///< of anything but `right`
};

/// Runs a scene in a process of its own and holds it to the truth: of steady gaps an evaluation
/// with 50 digits, of a box the flow law itself, of a Newtonian ramp from rest the exact series; of
/// all others a run of a tenth of the asked error (a third around a bob's ends), both bars counted.
/// A mangled case need only be refused or come to an end.
/// @param limit  CPU seconds of the scene; the truth may take as many again
[[nodiscard]] Trial try_scene(const RandomCase& scene, double limit,
                              const bench::StopQuestion& stop);

} // namespace searle::app
