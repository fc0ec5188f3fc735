#pragma once

#include <stdexcept>

namespace searle::app {

/// A word on the command line that the verb cannot use; what() says which, and what is allowed. The
/// program's exit code for it is 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace searle::app
