#include "app/verb_run.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress_line.hpp"
#include "app/result_message.hpp"
#include "app/run_summary.hpp"
#include "app/sweep_files.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

fs::path folder_for(const RunOptions& options) {
    return options.folder ? *options.folder : fs::path("results") / options.case_file.stem();
}

/// Solves case after case until one was interrupted; runs without a finished row are left out.
std::vector<SolvedCase> solve_all(std::vector<PlannedCase> planned, bool quiet) {
    const InterruptWatch watch;
    ProgressLine line(quiet);
    const solvers::ProgressSink sink = [&](double fraction, std::string_view stage) {
        if (watch.requested())
            throw solvers::Interrupted();
        line.show(fraction, stage);
    };
    std::vector<SolvedCase> solved;
    for (std::size_t i = 0; i < planned.size() && !watch.requested(); ++i) {
        if (planned.size() > 1)
            line.set_prefix(fmt::format("run {} of {}: ", i + 1, planned.size()));
        SolvedCase each = solve_case(std::move(planned[i]), sink);
        if (!each.rheogram.points.empty())
            solved.push_back(std::move(each));
    }
    return solved;
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

} // namespace

int run(const RunOptions& options) {
    StageClock clock;
    const std::vector<Case> cases = read_cases(options.case_file, options.overrides);
    clock.end_stage("read");
    if (cases.size() > 1)
        check_run_names(cases);
    const fs::path folder = folder_for(options);
    check_output_place(folder, options.replace);

    std::vector<PlannedCase> planned;
    for (const Case& each : cases) {
        planned.push_back(plan_case(each, clock));
        clock = StageClock();
    }
    const std::vector<SolvedCase> solved = solve_all(std::move(planned), options.quiet);
    if (solved.empty()) {
        tell("searle: interrupted before the first point; nothing was written\n");
        return ExitCode::interrupted;
    }
    if (cases.size() == 1) {
        const RunRecord record = record_of(solved.front(), present_time());
        write_result_folder(folder, files_of(record, ""), options.replace);
        if (!options.quiet)
            tell(result_message(record, folder));
        else
            tell_shortfall(record.summary.completeness, folder);
        return exit_code_for(record.summary.completeness);
    }
    const SweepRecord record = sweep_record(solved, cases, present_time());
    write_result_folder(folder, files_of(record), options.replace);
    if (!options.quiet)
        tell(result_message(record, folder));
    else
        tell_shortfall(record.summary.completeness, folder);
    return exit_code_for(record.summary.completeness);
}

} // namespace searle::app
