#pragma once

#include "app/summary_json.hpp"

#include <string>
#include <string_view>

namespace searle::app {

[[nodiscard]] std::string_view program_version();

/// The compiler and the kind of build: "GNU 12.2.0, Release".
[[nodiscard]] std::string compiler();

/// The libraries that the program was built with, by name.
[[nodiscard]] Versions library_versions();

/// Program, compiler and libraries together.
[[nodiscard]] Versions all_versions();

} // namespace searle::app
