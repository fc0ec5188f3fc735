#pragma once

namespace searle::app {

/// Reads the command line, runs the verb that it names, and turns what a verb throws into a message
/// on stderr. Returns the program's exit code.
[[nodiscard]] int run_command_line(int count, const char* const* words);

} // namespace searle::app
