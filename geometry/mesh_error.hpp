#pragma once

#include <stdexcept>

namespace searle::geometry {

/// The mesh that was asked for cannot be made; the message names the keys and values that are the
/// cause. Nothing was written. The program's exit code for it is 2.
struct MeshError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A program or a library that a mesh needs is not here; the message says how to get it.
/// The program's exit code for it is 4.
struct MeshToolMissing : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace searle::geometry
