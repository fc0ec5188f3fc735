#pragma once

#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/suspension/checkpoint.hpp"
#include "solvers/suspension/run_recorder.hpp"
#include "solvers/suspension/stress_sample.hpp"

#include <string>
#include <vector>

namespace searle::solvers::suspension {

/// What a run of a suspension gives: rows as every solver's, with the parts of the stress in them.
/// `worst_torque_imbalance` is the largest difference of wall and bulk stress of a row over its
/// stress; `reached` is false where a steady hold came to its largest strain before its statistical
/// error fell to 5 %.
struct SuspensionReport {
    radial::RadialReport solution;
    std::vector<StressSample> samples;               ///< the series that the rows were made of
    std::map<std::size_t, Microstructure> structure; ///< by row, with output.fields
    std::string failure; ///< why a step could not be taken; empty: all were
};

/// Largest strain of a step with hold = "steady".
inline constexpr double steady_strain_cap = 50.0;
/// Statistical error, over the stress, at which such a step ends.
inline constexpr double steady_statistical_error = 0.05;

/// Threads that a run of so many particles uses on this machine.
[[nodiscard]] int threads_for(double particles);

/// Runs the scene's particles through its protocol. Of a ramp or segment each row is the straight
/// line through the stresses up to a row before and after it, at its time; of a step the mean after
/// its start-up.
/// Throws UnsuitableScene where the particles cannot be packed, StepFailure where a step before the
/// first row cannot be taken.
/// @param checkpointing where to go on from, and where to save
/// @param frames        takes the frames of the trajectory (output.trajectory_strain)
[[nodiscard]] SuspensionReport solve_suspension(const Scene& scene, const Plan& plan,
                                                const ProgressSink& progress,
                                                const Checkpointing& checkpointing = {},
                                                const FrameSink& frames = {});

} // namespace searle::solvers::suspension
