#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct CompareOptions {
    std::filesystem::path case_file;
    std::string engines = "native,openfoam";     ///< at least two, with commas
    std::optional<std::filesystem::path> folder; ///< default: results/<stem>.compare
    std::vector<std::string> overrides;
    bool quiet = false;
    bool replace = false; ///< --force
};

/// `searle compare CASE --engines native,openfoam`: the same case on each engine, side by side.
/// The result folder holds a run an engine, one figure over all, rheograms.csv and comparison.csv;
/// a table of errors and times goes to standard output. Of a sweep each case is compared by itself.
/// Exit codes as `run`; throws UsageError for an engine that there is not.
[[nodiscard]] int compare(const CompareOptions& options);

} // namespace searle::app
