#include "app/verb_collect.hpp"

#include "app/exit_code.hpp"
#include "app/result_message.hpp"
#include "app/run_files.hpp"
#include "app/run_summary.hpp"
#include "app/usage_error.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

fs::path folder_for(const CollectOptions& options) {
    if (options.folder)
        return *options.folder;
    const fs::path place = settled_path(options.engine_folder);
    if (place.extension() != ".openfoam")
        throw UsageError(options.engine_folder.string() +
                         ": its name does not end in .openfoam, so -o must say where to");
    return place.parent_path() / place.stem();
}

} // namespace

int collect(const CollectOptions& options) {
    StageClock clock;
    const fs::path case_file = options.engine_folder / "case.toml";
    if (!fs::exists(case_file))
        throw UsageError(
            fmt::format("{}: holds no case.toml; a folder that searle run --write-only "
                        "or an interrupted run wrote is needed",
                        options.engine_folder.string()));
    Case source = read_case(case_file);
    clock.end_stage("read");
    if (source.scene.solver.engine != solvers::Engine::openfoam)
        throw UsageError(case_file.string() + ": solver.engine is not \"openfoam\"");
    const fs::path folder = folder_for(options);
    check_output_place(folder, options.replace);
    const SolvedCase solved =
        collect_case(plan_case(std::move(source), std::move(clock)), options.engine_folder);
    const RunRecord record = record_of(solved, present_time());
    write_result_folder(folder, files_of(record, ""), options.replace);
    if (!options.quiet)
        std::fputs(result_message(record, folder).c_str(), stderr);
    return record.summary.completeness == Completeness::complete ? ExitCode::done
                                                                 : ExitCode::not_reached;
}

} // namespace searle::app
