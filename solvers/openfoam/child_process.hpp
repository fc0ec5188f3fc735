#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::solvers::openfoam {

/// A program could not be started at all.
struct StartFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ChildProgram {
    std::vector<std::string> command; ///< program, found in PATH, and its arguments
    std::filesystem::path folder;     ///< where it runs; PWD says the same
    std::filesystem::path log;        ///< its output is appended
    std::filesystem::path project;    ///< WM_PROJECT_DIR
};

/// Runs a program in a process group of its own, so that a Ctrl-C at the terminal reaches this
/// program alone, and waits for it.
/// @param watch  called about every 50 ms, and must be quick. What it throws ends the program and
///               all it started (SIGTERM, after 5 s SIGKILL) and is passed on.
/// @return exit code; 128 + signal where a signal ended it
/// Throws StartFailure.
int run_program(const ChildProgram& program, const std::function<void()>& watch);

} // namespace searle::solvers::openfoam
