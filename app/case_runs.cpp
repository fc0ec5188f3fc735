#include "app/case_runs.hpp"

#include "app/checkpoint_file.hpp"
#include "app/engine_folder.hpp"
#include "app/interrupt.hpp"
#include "app/progress_line.hpp"
#include "app/trajectory_folder.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <optional>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

/// What stands beside the result folder, or, of a sweep, beside each run's.
fs::path beside(const Case& source, const fs::path& folder, bool sweeps, std::string_view ending) {
    return folder.string() + (sweeps ? "." + source.name : "") + std::string(ending);
}

/// Where a suspension's run is kept safe until the result folder is written.
fs::path checkpoint_of(const Case& source, const fs::path& folder, bool sweeps) {
    return beside(source, folder, sweeps, ".checkpoint.h5");
}

/// Solves a case with particles, from its checkpoint if there is one.
SolvedCase solve_suspension_safely(PlannedCase planned, const solvers::ProgressSink& sink,
                                   const RunPlace& place, bool sweeps) {
    const Case& source = planned.source;
    const CheckpointKeeper keeper(checkpoint_of(source, place.folder, sweeps), source.hash,
                                  place.replace, sweeps);
    if (keeper.goes_on() && !place.quiet)
        std::fputs(fmt::format("searle: goes on from {}\n", keeper.file().string()).c_str(),
                   stderr);
    RunKeeping keeping{.checkpointing = keeper.checkpointing(), .frames = {}, .engine_folder = {}};
    std::optional<TrajectoryFolder> trajectory;
    if (source.scene.output.trajectory_strain) {
        trajectory.emplace(beside(source, place.folder, sweeps, ".trajectory"), keeper.goes_on(),
                           place.replace);
        keeping.frames = [&trajectory](const solvers::suspension::Frame& frame) {
            trajectory->write(frame);
        };
    }
    SolvedCase solved = solve_case(std::move(planned), sink, keeping);
    if (!keeper.trouble().empty())
        solved.solution.notes.push_back(keeper.trouble());
    if (trajectory && !trajectory->trouble().empty())
        solved.solution.notes.push_back(trajectory->trouble());
    return solved;
}

/// Solves a case; one that takes long is kept safe.
SolvedCase solve_safely(PlannedCase planned, const solvers::ProgressSink& sink,
                        const RunPlace& place, bool sweeps) {
    if (planned.source.scene.particles)
        return solve_suspension_safely(std::move(planned), sink, place, sweeps);
    if (planned.source.scene.solver.engine != solvers::Engine::openfoam)
        return solve_case(std::move(planned), sink);
    const fs::path folder = engine_folder_for(planned.source, place.folder, sweeps);
    (void)installation_for(planned.source); // before anything is written
    check_engine_can_run_in(folder);
    if (open_engine_folder(folder, planned.source, place.replace) && !place.quiet)
        std::fputs(fmt::format("searle: goes on from {}\n", folder.string()).c_str(), stderr);
    try {
        return solve_case(std::move(planned), sink,
                          {.checkpointing = {}, .frames = {}, .engine_folder = folder});
    } catch (...) {
        remove_unused_engine_folder(folder);
        throw;
    }
}

} // namespace

SolvedRuns solve_all(std::vector<PlannedCase> planned, const RunPlace& place) {
    const bool quiet = place.quiet;
    const bool sweeps = planned.size() > 1;
    const InterruptWatch watch;
    ProgressLine line(quiet);
    const solvers::ProgressSink sink = [&](double fraction, std::string_view stage) {
        if (watch.requested())
            throw solvers::Interrupted();
        line.show(fraction, stage);
    };
    std::vector<fs::path> checkpoints;
    for (const PlannedCase& each : planned)
        checkpoints.push_back(checkpoint_of(each.source, place.folder, sweeps));
    SolvedRuns runs;
    for (std::size_t i = 0; i < planned.size() && !watch.requested(); ++i) {
        if (sweeps)
            line.set_prefix(fmt::format("run {} of {}: ", i + 1, planned.size()));
        const std::string name = planned[i].source.name;
        try {
            SolvedCase each = solve_safely(std::move(planned[i]), sink, place, sweeps);
            if (!each.rheogram.points.empty())
                runs.solved.push_back(std::move(each));
        } catch (const solvers::openfoam::OpenFoamFailed& error) {
            if (!sweeps)
                throw;
            runs.failures.push_back(fmt::format("{}: {}", name, error.what()));
        }
    }
    if (watch.requested())
        for (const fs::path& checkpoint : checkpoints)
            if (fs::exists(checkpoint))
                runs.checkpoints.push_back(checkpoint);
    return runs;
}

void remove_checkpoints(const std::vector<SolvedCase>& solved, const RunPlace& place, bool sweeps) {
    for (const SolvedCase& each : solved)
        if (each.source.scene.particles && !each.solution.interrupted) {
            std::error_code ignored;
            fs::remove(checkpoint_of(each.source, place.folder, sweeps), ignored);
        }
}

} // namespace searle::app
