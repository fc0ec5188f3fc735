#pragma once

#include <string>
#include <vector>

namespace searle::app {

struct VerifyOptions {
    std::vector<std::string> names; ///< beginnings of the checks' names; empty: all
    bool json{};
    bool markdown{};
    bool list{};
};

/// Holds solvers and laws to closed forms and known values, as a user's check of an installation.
/// Returns the exit code: 1 when a check fails.
int verify_installation(const VerifyOptions& options);

} // namespace searle::app
