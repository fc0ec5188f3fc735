#pragma once

#include "app/case_reader.hpp"
#include "solvers/plan.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// A case with its plan.
struct CasePlan {
    Case source;
    solvers::Plan plan;
};

/// The plans as JSON, with a line break at the end: one object for one case, a list of objects for
/// a sweep. Every object holds taylor.critical_reynolds and taylor.reynolds for an instrument with
/// cylinders (taylor is null for the box) and all rows. Keys are documented in docs/plan.md.
/// @param plans  at least one
[[nodiscard]] std::string plans_as_json(const std::vector<CasePlan>& plans);

} // namespace searle::app
