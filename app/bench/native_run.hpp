#pragma once

#include "app/bench/apart.hpp"
#include "app/bench/bench_scenes.hpp"
#include "app/bench/measurement.hpp"
#include "app/case_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::app::bench {

/// The scene's case with an accuracy asked.
[[nodiscard]] Case case_of(const BenchScene& scene, double accuracy);

/// What came out of solving a case in a process of its own, some times over.
struct NativeRun {
    bool reached{};
    double unknowns{};
    double estimate{};          ///< largest (torque_error + scatter) / |torque|
    std::vector<double> cpu;    ///< s, of each repeat: planning, solving, converting
    std::vector<double> times;  ///< s, of each row
    std::vector<double> speeds; ///< rad/s (m/s for the box)
    std::vector<double> torques;
    double peak_MiB{};
    std::string fault; ///< why there is nothing; empty: all well
};

/// @param least_seconds  repeated until so many CPU s have gone by, seven times at most
[[nodiscard]] NativeRun run_native(const Case& source, double least_seconds, double limit,
                                   const StopQuestion& stop);

/// What a scene's torques are to be.
struct Reference {
    std::vector<double> torques; ///< empty where a row's error comes from its own stress
    double error{};              ///< its own, relative
    std::string text;
    std::string fault; ///< why there is none
};
[[nodiscard]] Reference reference_for(const BenchScene& scene, double limit,
                                      const StopQuestion& stop);

/// Largest relative error of torques (N m; N for the box) at the scene's rows.
[[nodiscard]] double true_error(const BenchScene& scene, const Reference& reference,
                                const std::vector<double>& torques);

} // namespace searle::app::bench
