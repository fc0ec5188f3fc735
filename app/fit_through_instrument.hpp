#pragma once

#include "app/fit_record.hpp"
#include "app/verb_fit.hpp"

#include <vector>

namespace searle::app {

/// Reads raw torques and speeds, and the cases of the instruments they were measured with, and fits
/// the laws asked for through the simulated instruments; the same laws fitted to the converted
/// curve stand beside it. With --joint all files share the parameters. Rows beyond the onset of
/// Taylor vortices are left out, unless all are to be kept. Remarks go to stderr.
[[nodiscard]] std::vector<CurveRecord> fit_through_instrument(const FitVerbOptions& options);

} // namespace searle::app
