#pragma once

#include "app/case_keys.hpp"

namespace searle::app {

/// Adds the checks of what one section says against what another one says.
void add_case_checks(casefile::Keys<CaseAsWritten>& keys);

} // namespace searle::app
