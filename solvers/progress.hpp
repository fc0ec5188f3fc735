#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace searle::solvers {

/// Called now and then by a long computation: `fraction` done, 0 ... 1, and what is being done.
/// May throw Interrupted to stop it; the solver then hands out what is finished.
using ProgressSink = std::function<void(double fraction, std::string_view stage)>;

/// The user asked to stop (Ctrl-C).
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

} // namespace searle::solvers
