#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"

namespace searle::rheometry::fit {

/// Adds what a reader of the numbers should know: parameters that the data do not determine,
/// parameters on a bound or bound to each other, residuals that follow a pattern, weights that
/// bias.
void add_parameter_warnings(FitResult& result);

/// The same, and what only a flow curve shows; the data's own remarks first.
void add_warnings(FitResult& result, const Model& model, const FlowData& data);

} // namespace searle::rheometry::fit
