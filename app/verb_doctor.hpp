#pragma once

namespace searle::app {

/// `searle doctor`: prints to stdout which engines and libraries are there, their versions, what is
/// missing and how to get it. Returns the exit code: done when everything that the native engine
/// needs is there (an optional engine may be missing), else engine_missing.
[[nodiscard]] int doctor();

} // namespace searle::app
