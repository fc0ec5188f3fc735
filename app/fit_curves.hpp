#pragma once

#include "app/fit_record.hpp"
#include "app/verb_fit.hpp"

#include <vector>

namespace searle::app {

/// Tells on stderr which points were left out, counted by reason, with the lines of the first few.
void tell_of_excluded(const CurveRecord& curve);

/// Reads the rheograms and fits the laws asked for to each, or to all together. A curve that cannot
/// be fitted keeps its place, with the reason. Remarks on files and points go to stderr.
[[nodiscard]] std::vector<CurveRecord> fit_curves(const FitVerbOptions& options);

} // namespace searle::app
