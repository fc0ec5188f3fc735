#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace searle::app::bench {

/// How a process of its own ended.
struct Ended {
    std::vector<double> values{}; ///< what the work handed back; of a program: none
    std::string fault{};          ///< why there is no result; empty: all well
    double cpu{};                 ///< user and system time of the process, s
    double peak_MiB{};
    bool timed_out{};
};

/// Asked a hundred times a second while a process runs: true ends it.
using StopQuestion = std::function<bool()>;

/// Does `work` in a process of its own (fork), so that its memory and time are its own and a crash
/// costs only this result. An exception's text becomes the fault.
/// @param limit  wall-clock seconds until it is ended
[[nodiscard]] Ended work_apart(const std::function<std::vector<double>()>& work, double limit,
                               const StopQuestion& stop);

/// Runs a program to its end in `folder`; what it prints goes to `folder`/log.
/// @param words        program (found in PATH) and arguments
/// @param environment  NAME=VALUE, added to this process's
[[nodiscard]] Ended run_program(const std::vector<std::string>& words,
                                const std::filesystem::path& folder,
                                const std::vector<std::string>& environment, double limit,
                                const StopQuestion& stop);

/// A program is in PATH.
[[nodiscard]] bool is_installed(const std::string& program);

/// CPU seconds of this process.
[[nodiscard]] double process_seconds();

} // namespace searle::app::bench
