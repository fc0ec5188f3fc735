#include "app/verb_compare.hpp"

#include "app/case_runs.hpp"
#include "app/engine_comparison.hpp"
#include "app/exit_code.hpp"
#include "app/result_message.hpp"
#include "app/run_summary.hpp"
#include "app/sweep_files.hpp"
#include "app/usage_error.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> engines_of(const std::string& text) {
    std::vector<std::string> engines;
    std::istringstream parts(text);
    for (std::string name; std::getline(parts, name, ',');) {
        name.erase(0, name.find_first_not_of(' '));
        name.erase(name.find_last_not_of(' ') + 1);
        if (name != "native" && name != "openfoam")
            throw UsageError(
                fmt::format("--engines: '{}' is no engine; allowed: native, openfoam", name));
        if (std::ranges::count(engines, name) > 0)
            throw UsageError(fmt::format("--engines: {} stands there twice", name));
        engines.push_back(name);
    }
    if (engines.size() < 2)
        throw UsageError("--engines: two engines are compared, such as native,openfoam");
    return engines;
}

std::vector<Case> cases_of(const CompareOptions& options, const std::vector<std::string>& engines) {
    std::vector<Case> cases;
    for (const std::string& engine : engines) {
        std::vector<std::string> overrides = options.overrides;
        overrides.push_back("solver.engine=" + engine);
        std::vector<Case> read = read_cases(options.case_file, overrides);
        if (read.size() > 1)
            throw UsageError(
                options.case_file.string() +
                ": holds a sweep; one case is compared at a time (--set picks values)");
        read.front().name = engine;
        cases.push_back(std::move(read.front()));
    }
    return cases;
}

} // namespace

int compare(const CompareOptions& options) {
    const std::vector<std::string> engines = engines_of(options.engines);
    const std::vector<Case> cases = cases_of(options, engines);
    const fs::path folder = options.folder.value_or(
        fs::path("results") / (options.case_file.stem().string() + ".compare"));
    check_output_place(folder, options.replace);
    std::vector<PlannedCase> planned;
    for (const Case& each : cases) {
        if (each.scene.solver.engine == solvers::Engine::openfoam)
            (void)installation_for(each); // before the first engine spends its time
        planned.push_back(plan_case(each, StageClock()));
    }
    const SolvedRuns runs = solve_all(std::move(planned), {folder, options.replace, options.quiet});
    const std::vector<SolvedCase>& solved = runs.solved;
    if (solved.empty() && !runs.failures.empty())
        throw solvers::openfoam::OpenFoamFailed(runs.failures.front());
    if (solved.empty()) {
        std::fputs("searle: no engine finished a point; nothing was written\n", stderr);
        return ExitCode::interrupted;
    }
    SweepRecord record = sweep_record(solved, cases, present_time(), runs.failures);
    const std::vector<EngineAgreement> agreed = agreements(solved);
    for (const EngineAgreement& one : agreed)
        if (one.within < one.rows)
            record.summary.warnings.push_back(fmt::format(
                "{}: {} of {} rows differ from {} by more than both error bars, by up to "
                "{:.2g} times their sum.",
                one.engine, one.rows - one.within, one.rows, agreed.front().engine,
                one.worst_joint));
    record.summary.files.emplace_back("comparison.csv");
    std::vector<ResultFile> files = files_of(record);
    files.push_back({"comparison.csv", comparison_csv(solved)});
    write_result_folder(folder, files, options.replace);
    std::fputs(agreement_table(agreed).c_str(), stdout);
    if (!options.quiet)
        std::fputs(result_message(record, folder).c_str(), stderr);
    switch (record.summary.completeness) {
    case Completeness::interrupted:
        return ExitCode::interrupted;
    case Completeness::not_reached:
        return ExitCode::not_reached;
    case Completeness::complete:
        break;
    }
    return ExitCode::done;
}

} // namespace searle::app
