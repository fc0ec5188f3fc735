#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

struct PlanOptions {
    std::filesystem::path case_file;
    std::vector<std::string> overrides; ///< "key=value" texts of --set
    bool json = false;
};

/// `searle plan CASE.toml [--json]`: prints to stdout what would be solved, what is skipped and
/// why, the regime at each point and the expected cost; of every case of a sweep. With `json` one
/// object for a case, a list of objects for a sweep. Returns the exit code: done, also for a case
/// that this program cannot solve (the plan says so). Throws CaseError.
[[nodiscard]] int plan(const PlanOptions& options);

} // namespace searle::app
