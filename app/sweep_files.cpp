#include "app/sweep_files.hpp"

#include "app/versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace searle::app {
namespace {

constexpr std::string_view combined_csv = "rheograms.csv";
constexpr std::array top_files{std::string_view("report.html"), combined_csv,
                               std::string_view("summary.json")};

std::string written_value(const Case& source, const std::string& key) {
    const auto found = source.written.find(key);
    return found == source.written.end() ? "" : found->second;
}

double wall_seconds_of(const RunSummary& summary) {
    double seconds = 0.0;
    for (const StageSeconds& stage : summary.timings)
        seconds += stage.wall;
    return seconds;
}

/// The worse of two: what holds for one run holds for the sweep.
Completeness worse(Completeness left, Completeness right) {
    if (left == Completeness::interrupted || right == Completeness::interrupted)
        return Completeness::interrupted;
    return left == Completeness::complete ? right : left;
}

/// The runs' tables below each other, with the case's name in front.
std::string combined_table(const std::vector<RunRecord>& runs) {
    std::string table;
    std::string header;
    for (const RunRecord& run : runs) {
        std::string_view rest = run.csv;
        for (bool first = true; !rest.empty(); first = false) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view line = rest.substr(0, end);
            // Another instrument's columns can differ (the box); a new header says so.
            if (!first)
                table += fmt::format("{},{}\n", run.source.name, line);
            else if (line != header)
                table += fmt::format("case,{}\n", header = line);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return table;
}

} // namespace

std::vector<std::string> swept_keys_of(const std::vector<Case>& cases) {
    std::vector<std::string> keys;
    for (const auto& entry : cases.front().written) {
        const std::string& key = entry.first;
        const bool everywhere = std::all_of(cases.begin(), cases.end(), [&key](const Case& each) {
            return each.written.contains(key);
        });
        const bool differs = std::any_of(cases.begin(), cases.end(), [&entry](const Case& each) {
            return written_value(each, entry.first) != entry.second;
        });
        if (key != "title" && everywhere && differs)
            keys.push_back(key);
    }
    return keys;
}

SweepRecord sweep_record(const std::vector<SolvedCase>& solved, const std::vector<Case>& all_cases,
                         const std::string& created, const std::vector<std::string>& failures) {
    SweepRecord record;
    SweepSummary& summary = record.summary;
    summary.title = all_cases.front().scene.title;
    summary.case_file = all_cases.front().file.filename().string();
    summary.created = created;
    summary.versions = all_versions();
    summary.runs_asked = static_cast<long>(all_cases.size());
    summary.swept_keys = swept_keys_of(all_cases);
    summary.files.assign(top_files.begin(), top_files.end());
    for (const SolvedCase& each : solved) {
        RunRecord run = record_of(each, created);
        std::vector<std::string> values;
        for (const std::string& key : summary.swept_keys)
            values.push_back(written_value(run.source, key));
        summary.runs.push_back({.name = run.source.name,
                                .swept_values = std::move(values),
                                .completeness = run.summary.completeness,
                                .rows = run.summary.rows,
                                .wall_seconds = wall_seconds_of(run.summary)});
        summary.completeness = worse(summary.completeness, run.summary.completeness);
        for (const std::string& file : run.summary.files)
            summary.files.push_back(run.source.name + '/' + file);
        record.runs.push_back(std::move(run));
    }
    summary.remarks = remarks_on(summary, record.runs);
    if (!failures.empty()) {
        summary.completeness = worse(summary.completeness, Completeness::not_reached);
        summary.warnings.insert(summary.warnings.end(), failures.begin(), failures.end());
    }
    if (solved.size() + failures.size() < all_cases.size()) {
        summary.completeness = Completeness::interrupted;
        summary.warnings.push_back(
            fmt::format("Interrupted: {} of {} runs were made.", solved.size(), all_cases.size()));
    }
    return record;
}

std::vector<ResultFile> files_of(const SweepRecord& record) {
    std::vector<ResultFile> files;
    for (const RunRecord& run : record.runs)
        for (ResultFile& file : files_of(run, run.source.name + '/'))
            files.push_back(std::move(file));
    files.push_back({"report.html", overlay_page(record.summary, record.runs)});
    files.push_back({std::string(combined_csv), combined_table(record.runs)});
    files.push_back({"summary.json", summary_json(record.summary)});
    return files;
}

bool is_top_file(std::string_view name) {
    return std::find(top_files.begin(), top_files.end(), name) != top_files.end();
}

SweepRecord read_sweep_record(const std::filesystem::path& folder) {
    SweepRecord record;
    record.summary = read_sweep_summary(text_of_file(folder / "summary.json"));
    for (const SweepRun& run : record.summary.runs)
        record.runs.push_back(read_record(folder / run.name));
    return record;
}

} // namespace searle::app
