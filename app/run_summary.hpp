#pragma once

#include "app/solved_case.hpp"
#include "app/summary_json.hpp"

#include <string>

namespace searle::app {

/// Now, UTC, ISO 8601: "2024-05-17T09:30:00Z".
[[nodiscard]] std::string present_time();

/// What summary.json says of a solved case. `created` comes from present_time().
[[nodiscard]] RunSummary run_summary(const SolvedCase& solved, const std::string& created);

} // namespace searle::app
