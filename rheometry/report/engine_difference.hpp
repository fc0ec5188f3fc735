#pragma once

#include "rheometry/report/figure.hpp"
#include "rheometry/report/report_input.hpp"

#include <optional>

namespace searle::rheometry::report {

/// Runs that differ in `solver.engine` alone: the stress of each against that of the first of them,
/// row by row, in %, with the sum of both errors as bar. None where no such runs are.
[[nodiscard]] std::optional<Figure> engine_difference_figure(const OverlayInput& input);

} // namespace searle::rheometry::report
