#pragma once

#include <cstddef>
#include <span>

namespace searle::solvers::suspension {

/// How many values at the start are not yet those of the steady state: the truncation with the
/// smallest marginal standard error (White 1997, Simulation 69, 323), found on means of five
/// values; at most half of the series.
[[nodiscard]] std::size_t start_up_length(std::span<const double> values);

} // namespace searle::solvers::suspension
