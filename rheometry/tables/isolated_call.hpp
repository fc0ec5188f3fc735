#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace searle::rheometry {

struct IsolatedResult {
    enum class Outcome {
        finished,
        crashed,     ///< the process was ended by a signal, or failed on its own
        out_of_time, ///< it used more than its processor time
        no_process   ///< the system would not start one
    };
    Outcome outcome = Outcome::no_process;
    std::string output; ///< what the call returned, when it finished
};

struct IsolationLimits {
    unsigned processor_seconds = 20;
    std::size_t memory = std::size_t{4} << 30U; ///< bytes that it may add; std::bad_alloc beyond
};

/// Runs a call in a process of its own and hands back what it returns, so that whatever goes wrong
/// in a library with a damaged file stays there. The call sees the state of this process at the
/// time; what it changes is lost, what it prints is dropped. Call it while no other thread is
/// at work.
[[nodiscard]] IsolatedResult call_isolated(const std::function<std::string()>& call,
                                           IsolationLimits limits = {});

} // namespace searle::rheometry
