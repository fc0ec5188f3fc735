#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace searle::solvers::openfoam {

/// What the end of a solver's log says.
struct LogTail {
    std::optional<double> time;    ///< of the step that was begun last
    std::optional<double> courant; ///< largest Courant number of the last step
    std::string fatal;             ///< first lines of a fatal error, in one; empty: none
};

/// Reads the last 16 kB of a log. Empty where it cannot be read.
[[nodiscard]] LogTail log_tail(const std::filesystem::path& log);

/// The version that wrote a log, as its head says ("1912", "8-1c9b5879390b"); empty: it does not.
[[nodiscard]] std::string version_in_log(const std::filesystem::path& log);

} // namespace searle::solvers::openfoam
