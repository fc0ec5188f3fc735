#pragma once

#include "app/fit_record.hpp"
#include "app/instrument_series.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// The model-free inversion of each series and its ramp's loop, from torques whose ends and inertia
/// are taken out as computed with the law; beside each row what the law gives at its speed. Kept in
/// the record when this is the first law, or the best so far by AICc.
void add_model_free(CurveRecord& record, const fit::Model& law,
                    const solvers::fit_instrument::InstrumentFit& done,
                    const PreparedSeries& prepared);

/// What a reader should know of the loops, a sentence each.
[[nodiscard]] std::vector<std::string> loop_warnings(const CurveRecord& record);

} // namespace searle::app
