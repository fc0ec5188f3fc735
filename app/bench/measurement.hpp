#pragma once

#include <limits>
#include <string>
#include <vector>

namespace searle::app::bench {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One point of a work-precision curve: a code with one setting on one scene.
struct Measurement {
    std::string code{};    ///< "searle", or the peer's program
    std::string setting{}; ///< "accuracy 1e-3", "1 deg, 40 cells, step 0.02 s"
    double asked = unknown;
    /// Largest relative error of the torques (forces) over the scene's rows against the reference.
    double true_error = unknown;
    double estimate = unknown; ///< largest relative error that the code itself states
    /// CPU seconds of the computation: of searle planning, solving and converting, of a peer its
    /// whole process without the making of the mesh. Median and least of the repeats.
    double cpu_median = unknown;
    double cpu_least = unknown;
    int repeats{};
    double unknowns = unknown; ///< of the finest system solved
    double peak_MiB = unknown; ///< most memory that the process held
    std::string remark{};      ///< what went wrong, or what the reader has to know; may be empty
};

/// What was measured on one scene.
struct SceneResult {
    std::string name{};
    std::string title{};
    std::string kind{};      ///< the class of scenes
    std::string reference{}; ///< what the errors are against, and how far that can be trusted
    double reference_error{};
    /// Errors below the reference's own are drawn and compared as that.
    std::vector<Measurement> points{};
    /// CPU s of `searle run` as a whole (start, reading, solving, report) at accuracy 1e-3.
    double whole_program = unknown;
    /// Not a curve but a cost: what the seconds are for, e.g. "CPU s per unit strain".
    std::string cost_unit{};
};

/// How much cheaper searle is than a peer where both are equally far off.
struct Ratio {
    std::string scene{};
    std::string code{};
    std::string peer{}; ///< code and setting
    double error{};     ///< the peer's true error
    double peer_cpu{};
    double own_cpu{}; ///< on searle's curve at that error, log-log
    double ratio{};
    bool at_least{}; ///< searle was more accurate than the peer at its cheapest: a lower bound
};

struct BenchResult {
    std::string version;
    std::string created;
    std::string machine; ///< processor, number, load: what a reader has to know about the times
    bool quick{};
    bool interrupted{};
    std::vector<SceneResult> scenes;
    std::vector<std::string> notes;
};

} // namespace searle::app::bench
