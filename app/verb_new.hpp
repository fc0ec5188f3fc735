#pragma once

#include <string>

namespace searle::app {

struct NewOptions {
    std::string geometry; ///< single-gap, double-gap, din-bob or box
};

/// `searle new GEOMETRY`: prints a commented case file to start from to stdout.
/// Returns the exit code: 0, or 2 for a geometry that does not exist (message on stderr).
[[nodiscard]] int new_case(const NewOptions& options);

} // namespace searle::app
