#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct EndsOptions {
    std::filesystem::path case_file;
    std::vector<std::string> overrides;          ///< "key=value" texts of --set
    std::optional<std::string> rates;            ///< 1/s: "A,B,..." or "LOW:HIGH:COUNT"
    std::optional<std::filesystem::path> output; ///< a file in place of standard output
    bool json = false;
    bool csv = false;
    bool quiet = false;
};

/// `searle ends CASE.toml`: end factors of the case's instrument and fluid over the speed, with
/// error bars and energy bounds, to stdout or a file. Returns the exit code: done, not_reached,
/// interrupted (what was finished is printed). Throws CaseError, UsageError, EngineMissing for an
/// instrument without ends.
[[nodiscard]] int ends(const EndsOptions& options);

} // namespace searle::app
