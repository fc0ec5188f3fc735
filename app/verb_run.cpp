#include "app/verb_run.hpp"

#include "app/case_runs.hpp"
#include "app/engine_folder.hpp"
#include "app/exit_code.hpp"
#include "app/result_message.hpp"
#include "app/run_summary.hpp"
#include "app/sleeping_threads.hpp"
#include "app/sweep_files.hpp"
#include "app/usage_error.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"
#include "solvers/suspension/suspension_plan.hpp"
#include "solvers/suspension/suspension_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

fs::path folder_for(const RunOptions& options) {
    return options.folder ? *options.folder : fs::path("results") / options.case_file.stem();
}

int exit_code_for(Completeness completeness) {
    switch (completeness) {
    case Completeness::interrupted:
        return ExitCode::interrupted;
    case Completeness::not_reached:
        return ExitCode::not_reached;
    case Completeness::complete:
        break;
    }
    return ExitCode::done;
}

/// A run's subfolder must not take the place of a file at the top of the folder.
void check_run_names(const std::vector<Case>& cases) {
    for (const Case& each : cases)
        if (is_top_file(each.name))
            throw OutputPlaceError(fmt::format(
                "{}: a run of the sweep is named {}, which is a file of the result folder",
                each.file.string(), each.name));
}

void tell(const std::string& message) { std::fputs(message.c_str(), stderr); }

/// What even --quiet says: that the exit code is not 0, and why.
void tell_shortfall(Completeness completeness, const fs::path& folder) {
    if (completeness == Completeness::not_reached)
        tell(fmt::format(
            "searle: the asked accuracy was not reached; results with their error bars: {}\n",
            folder.string()));
    else if (completeness == Completeness::interrupted)
        tell(fmt::format("searle: interrupted; what was finished: {}\n", folder.string()));
}

/// How to go on with an interrupted suspension, whose finished rows are written.
void tell_continuation(const SolvedRuns& runs) {
    if (!runs.checkpoints.empty())
        tell(fmt::format("searle: the same command with --force goes on from {}\n",
                         runs.checkpoints.back().string()));
}

bool uses_threads(const PlannedCase& planned) {
    const solvers::Scene& scene = planned.source.scene;
    return scene.particles && planned.plan.can_be_solved &&
           solvers::suspension::threads_for(solvers::suspension::choose(scene).count) > 1;
}

/// Writes OpenFOAM's cases without running them.
int write_cases(const std::vector<Case>& cases, const RunOptions& options) {
    for (const Case& each : cases) {
        if (each.scene.solver.engine != solvers::Engine::openfoam)
            throw UsageError(each.file.string() +
                             ": --write-only is for solver.engine = \"openfoam\"");
        const solvers::Plan plan = solvers::make_plan(each.scene);
        const fs::path folder =
            options.folder ? (cases.size() > 1 ? *options.folder / each.name : *options.folder)
                           : engine_folder_for(each, folder_for(options), cases.size() > 1);
        (void)open_engine_folder(folder, each, options.replace);
        try {
            solvers::openfoam::write_levels(
                each.scene, solvers::openfoam::plan_foam(each.scene, plan), folder, {});
        } catch (...) {
            remove_unused_engine_folder(folder);
            throw;
        }
        if (!options.quiet)
            tell(
                fmt::format("searle: written: {0}\nRun Allrun in each of its level-* folders, then "
                            "searle collect {0}\n",
                            folder.string()));
    }
    return ExitCode::done;
}

} // namespace

int run(const RunOptions& options) {
    StageClock clock;
    const std::vector<Case> cases = read_cases(options.case_file, options.overrides);
    clock.end_stage("read");
    if (options.write_only)
        return write_cases(cases, options);
    if (cases.size() > 1)
        check_run_names(cases);
    const fs::path folder = folder_for(options);
    check_output_place(folder, options.replace);
    const RunPlace place{folder, options.replace, options.quiet};

    std::vector<PlannedCase> planned;
    for (const Case& each : cases) {
        planned.push_back(plan_case(each, clock));
        clock = StageClock();
    }
    if (std::ranges::any_of(planned, uses_threads))
        restart_with_sleeping_threads();
    const SolvedRuns runs = solve_all(std::move(planned), place);
    const std::vector<SolvedCase>& solved = runs.solved;
    if (solved.empty() && !runs.failures.empty())
        throw solvers::openfoam::OpenFoamFailed(runs.failures.front());
    if (solved.empty()) {
        tell(runs.checkpoints.empty()
                 ? "searle: interrupted before the first point; nothing was written\n"
                 : fmt::format("searle: interrupted before the first point; the same command goes "
                               "on from {}\n",
                               runs.checkpoints.back().string()));
        return ExitCode::interrupted;
    }
    if (cases.size() == 1) {
        const RunRecord record = record_of(solved.front(), present_time());
        write_result_folder(folder, files_of(record, ""), options.replace);
        if (runs.checkpoints.empty())
            remove_checkpoints(solved, place, false);
        if (!options.quiet)
            tell(result_message(record, folder));
        else
            tell_shortfall(record.summary.completeness, folder);
        tell_continuation(runs);
        return exit_code_for(record.summary.completeness);
    }
    const SweepRecord record = sweep_record(solved, cases, present_time(), runs.failures);
    write_result_folder(folder, files_of(record), options.replace);
    if (runs.checkpoints.empty())
        remove_checkpoints(solved, place, true);
    if (!options.quiet)
        tell(result_message(record, folder));
    else
        tell_shortfall(record.summary.completeness, folder);
    tell_continuation(runs);
    return exit_code_for(record.summary.completeness);
}

} // namespace searle::app
