#include "app/verb_report.hpp"

#include "app/exit_code.hpp"
#include "app/result_folder.hpp"
#include "app/sweep_files.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

int refuse(const fs::path& folder, std::string_view reason) {
    std::fputs(fmt::format("searle report: {}: {}\n", folder.string(), reason).c_str(), stderr);
    return ExitCode::wrong_usage;
}

std::vector<ResultFile> reports_in(const fs::path& folder, SummaryKind kind) {
    if (kind == SummaryKind::run)
        return {{"report.html", report_page(read_record(folder))}};
    const SweepRecord sweep = read_sweep_record(folder);
    std::vector<ResultFile> reports{{"report.html", overlay_page(sweep.summary, sweep.runs)}};
    for (const RunRecord& run : sweep.runs)
        reports.push_back({run.summary.origin.name + "/report.html", report_page(run)});
    return reports;
}

} // namespace

int report(const ReportOptions& options) {
    const fs::path& folder = options.folder;
    if (!fs::is_directory(folder))
        return refuse(folder, fs::exists(folder) ? "is not a folder" : "there is no such folder");
    std::vector<ResultFile> reports;
    try {
        const SummaryKind kind = kind_of_summary(text_of_file(folder / "summary.json"));
        if (kind == SummaryKind::none)
            return refuse(folder / "summary.json", "is not that of a Searle result");
        reports = reports_in(folder, kind);
    } catch (const std::exception& error) {
        return refuse(folder, fmt::format("the report cannot be made again: {}", error.what()));
    }
    for (const ResultFile& file : reports)
        replace_file(folder / file.name, file.content);
    std::fputs(fmt::format("{}\n", (folder / "report.html").string()).c_str(), stderr);
    return ExitCode::done;
}

} // namespace searle::app
