#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace searle::app {

struct CheckOptions {
    std::filesystem::path case_file;
    std::vector<std::string> overrides; ///< "key=value" texts of --set
};

/// `searle check CASE.toml`: reads and validates only; prints what was understood to stdout, a line
/// for each case of a sweep. Returns 0; throws CaseError for a faulty case.
[[nodiscard]] int check(const CheckOptions& options);

} // namespace searle::app
