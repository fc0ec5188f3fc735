#pragma once

#include "app/case_reader.hpp"
#include "solvers/axisymmetric/end_effect_table.hpp"

#include <string>

namespace searle::app {

/// The table of `searle ends --json`: case, geometry, fluid, whether the accuracy was reached, and
/// the rows.
[[nodiscard]] std::string ends_as_json(const solvers::axisymmetric::EndEffectTable& table,
                                       const Case& source);

} // namespace searle::app
