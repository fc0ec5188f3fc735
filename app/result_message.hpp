#pragma once

#include "app/sweep_files.hpp"

#include <filesystem>
#include <string>

namespace searle::app {

/// A few lines for the person at the terminal: where the results are, what they are worth, what to
/// look out for. Ends with a line end.
[[nodiscard]] std::string result_message(const RunRecord& record,
                                         const std::filesystem::path& folder);
[[nodiscard]] std::string result_message(const SweepRecord& record,
                                         const std::filesystem::path& folder);

} // namespace searle::app
