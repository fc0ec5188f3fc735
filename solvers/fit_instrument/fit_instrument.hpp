#pragma once

#include "rheometry/fit/fit.hpp"
#include "solvers/fit_instrument/instrument_forward.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::solvers::fit_instrument {

/// A law fitted to torques through the instruments they were measured with.
struct InstrumentFit {
    rheometry::fit::FitResult result; ///< with `slip_coefficient` as its last parameter, if asked
    /// The same law fitted to the stresses and rates of the conversion, as a lab does it.
    std::optional<rheometry::fit::FitResult> conventional;
};

/// @param measurements    one or several instruments, same fluid
/// @param converted       all rows by the instruments' conversions, as select_points gives them;
/// the
///                        starting values come from it
/// @param slip            fit a wall slip too; needs two gaps of different widths
/// Throws rheometry::fit::FitError.
[[nodiscard]] InstrumentFit fit_through(const rheometry::fit::Model& law,
                                        const std::vector<Measurement>& measurements,
                                        const rheometry::fit::FlowData& converted,
                                        const rheometry::fit::FitOptions& options, bool slip);

} // namespace searle::solvers::fit_instrument
