#pragma once

#include "app/plan_as_json.hpp"

#include <string>

namespace searle::app {

/// A plan for people, sentences broken at 100 characters: what will be solved first, then what is
/// skipped and why, the regimes of the rows, and the warnings.
[[nodiscard]] std::string plan_as_text(const CasePlan& planned);

} // namespace searle::app
