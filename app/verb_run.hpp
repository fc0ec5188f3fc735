#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct RunOptions {
    std::filesystem::path case_file;
    std::optional<std::filesystem::path> folder; ///< default: results/<case file's stem>
    std::vector<std::string> overrides;          ///< "key=value" texts of --set
    bool quiet = false;                          ///< nothing on stderr but errors
    bool replace = false;                        ///< --force
    bool write_only = false; ///< OpenFOAM's cases are written, not run; `folder` is theirs
};

/// `searle run CASE.toml`: case, plan, solver, rheogram, report. The result folder appears as a
/// whole, at the end. Returns the exit code: done; not_reached or interrupted, with what was
/// finished kept; throws CaseError, OutputPlaceError, OutputWriteError and EngineMissing.
[[nodiscard]] int run(const RunOptions& options);

} // namespace searle::app
