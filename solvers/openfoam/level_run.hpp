#pragma once

#include "solvers/openfoam/foam_plan.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/progress.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::solvers::openfoam {

/// What one level of refinement gave. Torques are the whole instrument's, N m (N for a box).
struct LevelResult {
    std::vector<double> torque; ///< of the drive on the rotor, of the rows finished, in order
    /// Of each row: what is left of the balance of a steady row's two torques, or how much it would
    /// still move as its last iterations tell, whichever is more; 0 for rows in time.
    std::vector<double> unsettled;
    /// | integral of (M_bob - M_cup) dt - (L(end) - L(start)) | over the integral of |M_bob|, L the
    /// fluid's angular momentum (for a box forces and momentum); for steady rows the largest
    /// |M_bob - M_cup| / |M_bob|. None where the run did not reach its end.
    std::optional<double> imbalance;
    /// Chords in place of arcs: relative error of the rotor's area.
    double chord_error{};
    std::size_t cells{};
    long steps{};        ///< time steps, or iterations
    bool interrupted{};  ///< the rows finished are there; a later run goes on
    std::string failure; ///< why it ended early, a sentence; empty: it did not
    bool blew_up{};      ///< the program itself ended with a fault
    std::vector<std::string> notes;
};

struct LevelTask {
    const Scene& scene;
    const FoamPlan& plan;
    int level{};
    std::filesystem::path folder; ///< of the level's case
    const Installation& installation;
    /// Case of the level before, whose steady rows those of this level start from; empty: none.
    std::filesystem::path coarser{};
};

/// Writes the level's case without running it. A case that is there is left as it is.
void prepare_level(const LevelTask& task);

/// Writes the case where it is not there yet, runs it on from where it stands, and reads it.
/// Throws UnsuitableScene where the folder holds a case that was changed by hand, StartFailure,
/// DiskFull.
[[nodiscard]] LevelResult run_level(const LevelTask& task, const ProgressSink& progress);

/// Reads a level that was run, wherever that was. Files that were changed since they were written
/// are named in the notes.
[[nodiscard]] LevelResult read_level(const LevelTask& task);

} // namespace searle::solvers::openfoam
