#pragma once

#include <functional>

namespace searle::app {

/// Calls a verb and turns what it throws into a message on stderr and an exit code. Sees to it that
/// what the verb printed has arrived: a full disk behind stdout is a failure too.
[[nodiscard]] int with_failures_told(const std::function<int()>& verb);

} // namespace searle::app
