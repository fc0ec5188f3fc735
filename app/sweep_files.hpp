#pragma once

#include "app/run_files.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

/// What the files at the top of a sweep's result folder are made from.
struct SweepRecord {
    SweepSummary summary;
    std::vector<RunRecord> runs; ///< in the order of the summary's runs
};

/// @param solved      the runs that were made, in the sweep's order
/// @param all_cases   all cases that the sweep has
/// @param failures    why runs gave nothing, a sentence each
[[nodiscard]] SweepRecord sweep_record(const std::vector<SolvedCase>& solved,
                                       const std::vector<Case>& all_cases,
                                       const std::string& created,
                                       const std::vector<std::string>& failures = {});

/// All files of a sweep's result folder: case by case, and at the top summary.json, report.html
/// and rheograms.csv, which has the columns `case` and those of rheogram.csv.
[[nodiscard]] std::vector<ResultFile> files_of(const SweepRecord& record);

/// Whether a file of this name stands at the top of a sweep's result folder.
[[nodiscard]] bool is_top_file(std::string_view name);

/// Reads a sweep's result folder again. Throws as read_record does.
[[nodiscard]] SweepRecord read_sweep_record(const std::filesystem::path& folder);

/// Dotted keys that all cases of a sweep have and in which they differ, sorted. What only some have
/// (another protocol's keys) is told by the cases' names.
[[nodiscard]] std::vector<std::string> swept_keys_of(const std::vector<Case>& cases);

} // namespace searle::app
