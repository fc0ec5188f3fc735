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

/// The same case for each engine, or those of a sweep, case by case.
struct CasesForEngines {
    std::vector<std::string> names; ///< of a sweep's cases; one empty name where there is none
    std::vector<Case> cases;        ///< engine by engine of the first name, then of the next
};

CasesForEngines cases_of(const CompareOptions& options, const std::vector<std::string>& engines) {
    std::vector<std::vector<Case>> read;
    for (const std::string& engine : engines) {
        std::vector<std::string> overrides = options.overrides;
        overrides.push_back("solver.engine=" + engine);
        read.push_back(read_cases(options.case_file, overrides));
    }
    CasesForEngines all;
    const bool sweeps = read.front().size() > 1;
    for (std::size_t at = 0; at < read.front().size(); ++at) {
        all.names.push_back(sweeps ? read.front()[at].name : "");
        for (std::size_t engine = 0; engine < engines.size(); ++engine) {
            Case& each = read[engine][at];
            each.name = sweeps ? each.name + '-' + engines[engine] : engines[engine];
            all.cases.push_back(std::move(each));
        }
    }
    return all;
}

/// What was solved, by case; cases that no engine finished are left out.
std::vector<ComparedCase> by_case(const CasesForEngines& all, const std::vector<SolvedCase>& solved,
                                  std::size_t engines) {
    std::vector<ComparedCase> cases;
    for (std::size_t at = 0; at < all.names.size(); ++at) {
        ComparedCase one{.name = all.names[at], .solved = {}};
        for (std::size_t engine = 0; engine < engines; ++engine)
            for (const SolvedCase& each : solved)
                if (each.source.name == all.cases[at * engines + engine].name)
                    one.solved.push_back(&each);
        if (!one.solved.empty())
            cases.push_back(std::move(one));
    }
    return cases;
}

void warn_of_differences(const ComparedCase& compared, std::vector<std::string>& warnings) {
    const std::vector<EngineAgreement> agreed = agreements(compared);
    for (const EngineAgreement& one : agreed)
        if (one.within < one.rows)
            warnings.push_back(fmt::format(
                "{}{}: {} of {} rows differ from {} by more than both error bars, by up to "
                "{:.2g} times their sum.",
                compared.name.empty() ? "" : compared.name + ", ", one.engine,
                one.rows - one.within, one.rows, agreed.front().engine, one.worst_joint));
}

} // namespace

int compare(const CompareOptions& options) {
    const std::vector<std::string> engines = engines_of(options.engines);
    const CasesForEngines all = cases_of(options, engines);
    const fs::path folder = options.folder.value_or(
        fs::path("results") / (options.case_file.stem().string() + ".compare"));
    check_output_place(folder, options.replace);
    std::vector<PlannedCase> planned;
    for (const Case& each : all.cases) {
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
    SweepRecord record = sweep_record(solved, all.cases, present_time(), runs.failures);
    const std::vector<ComparedCase> compared = by_case(all, solved, engines.size());
    for (const ComparedCase& each : compared) {
        warn_of_differences(each, record.summary.warnings);
        for (std::string& remark : agreement_remarks(each))
            record.summary.remarks.push_back(std::move(remark));
    }
    record.summary.files.emplace_back("comparison.csv");
    std::vector<ResultFile> files = files_of(record);
    files.push_back({"comparison.csv", comparison_csv(compared)});
    write_result_folder(folder, files, options.replace);
    for (const ComparedCase& each : compared)
        std::fputs(agreement_table(each).c_str(), stdout);
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
