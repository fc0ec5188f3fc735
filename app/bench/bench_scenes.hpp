#pragma once

#include <string>
#include <vector>

namespace searle::app::bench {

/// What the torques of a scene are held to.
enum class Truth {
    start_up_series, ///< Newtonian ramp from rest: the exact series of the annulus or plane gap
    double_gap_ramp, ///< Newtonian ramp from rest: both gaps in closed form, past their start
    steady_gap,      ///< any law, steady: an evaluation with 50 digits
    finer_run,       ///< the program's own run at `reference_accuracy`, whose error bar is stated
    known_value      ///< a relative viscosity from elsewhere
};

/// A scene of the benchmark: a case, the accuracies that are asked, and the truth.
struct BenchScene {
    std::string name{};
    std::string title{};
    std::string kind{}; ///< the class of scenes
    std::string case_text{};
    std::vector<double> accuracies{};
    std::vector<double> quick_accuracies{};
    Truth truth{};
    double reference_accuracy{};       ///< of finer_run
    double relative_viscosity{};       ///< of known_value
    double relative_viscosity_error{}; ///< relative
    std::string source{};              ///< of known_value
    double strain{}; ///< of a suspension: what its seconds are divided by; 0: they are not
    bool long_run{}; ///< left out of --quick
};

/// All scenes, the cheap ones first within a class.
[[nodiscard]] const std::vector<BenchScene>& bench_scenes();

} // namespace searle::app::bench
