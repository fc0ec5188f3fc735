#pragma once

#include <stdexcept>

namespace searle::solvers {

/// A scene whose values, each allowed by itself, cannot be computed together: what, and what would
/// be possible. The user's case is to be changed.
struct UnsuitableScene : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace searle::solvers
