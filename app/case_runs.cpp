#include "app/case_runs.hpp"

#include "app/checkpoint_file.hpp"
#include "app/engine_folder.hpp"
#include "app/interrupt.hpp"
#include "app/progress_line.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

/// Where a suspension's run is kept safe until the result folder is written.
fs::path checkpoint_of(const Case& source, const fs::path& folder, bool sweeps) {
    return folder.string() + (sweeps ? "." + source.name : "") + ".checkpoint.h5";
}

/// Solves a case; one with particles goes on from its checkpoint, and is kept in it.
SolvedCase solve_safely(PlannedCase planned, const solvers::ProgressSink& sink,
                        const fs::path& checkpoint, const fs::path& engine_folder,
                        const RunPlace& place) {
    if (planned.source.scene.solver.engine == solvers::Engine::openfoam) {
        (void)installation_for(planned.source); // before anything is written
        check_engine_can_run_in(engine_folder);
        if (open_engine_folder(engine_folder, planned.source, place.replace) && !place.quiet)
            std::fputs(fmt::format("searle: goes on from {}\n", engine_folder.string()).c_str(),
                       stderr);
        try {
            return solve_case(std::move(planned), sink,
                              {.checkpointing = {}, .engine_folder = engine_folder});
        } catch (...) {
            remove_unused_engine_folder(engine_folder);
            throw;
        }
    }
    if (!planned.source.scene.particles)
        return solve_case(std::move(planned), sink);
    const CheckpointKeeper keeper(checkpoint, planned.source.hash, place.replace);
    if (keeper.goes_on() && !place.quiet)
        std::fputs(fmt::format("searle: goes on from {}\n", checkpoint.string()).c_str(), stderr);
    SolvedCase solved = solve_case(std::move(planned), sink,
                                   {.checkpointing = keeper.checkpointing(), .engine_folder = {}});
    if (!keeper.trouble().empty())
        solved.solution.notes.push_back(keeper.trouble());
    return solved;
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
    SolvedRuns runs;
    for (std::size_t i = 0; i < planned.size() && !watch.requested(); ++i) {
        if (sweeps)
            line.set_prefix(fmt::format("run {} of {}: ", i + 1, planned.size()));
        const fs::path checkpoint = checkpoint_of(planned[i].source, place.folder, sweeps);
        const fs::path engine_folder = engine_folder_for(planned[i].source, place.folder, sweeps);
        const std::string name = planned[i].source.name;
        try {
            SolvedCase each =
                solve_safely(std::move(planned[i]), sink, checkpoint, engine_folder, place);
            if (!each.rheogram.points.empty())
                runs.solved.push_back(std::move(each));
        } catch (const solvers::openfoam::OpenFoamFailed& error) {
            if (!sweeps)
                throw;
            runs.failures.push_back(fmt::format("{}: {}", name, error.what()));
        }
    }
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
