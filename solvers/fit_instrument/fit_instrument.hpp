#pragma once

#include "rheometry/fit/fit.hpp"
#include "solvers/fit_instrument/instrument_forward.hpp"
#include "solvers/fit_instrument/ramp_inertia.hpp"
#include "solvers/progress.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace searle::solvers::fit_instrument {

/// The whole run that a measurement's rows were taken from, for its inertia.
struct RunHistory {
    TimedRows rows; ///< all rows, signs included; without a history (has_history): no inertia
    std::vector<double> torques;   ///< N m, as many; for an estimate of the viscosity
    std::vector<std::size_t> used; ///< row of the run per row of the measurement
};

/// What is computed beside the steady flow in the gaps.
struct InstrumentEffects {
    /// c_L of DIN bobs from the flow around their ends; else the measurement's stay.
    bool ends = true;
    double density{};                  ///< kg/m^3, > 0
    std::vector<RunHistory> history{}; ///< per measurement; empty: no inertia
    ProgressSink progress{};
};

/// How c_L of one DIN bob came out.
struct ComputedEnds {
    std::size_t measurement{};
    std::vector<double> values; ///< per row, at the fitted parameters
    double relative_error{};
    int solutions{};
    bool reached = true;
    /// Of a law that the solvers do not know: the law whose c_L is taken.
    std::string stand_in;
};

/// A law fitted to torques through the instruments they were measured with.
struct InstrumentFit {
    rheometry::fit::FitResult result; ///< with `slip_coefficient` as its last parameter, if asked
    /// The same law fitted to the stresses and rates of the conversion, as a lab does it.
    std::optional<rheometry::fit::FitResult> conventional;
    std::vector<ComputedEnds> ends;
    /// Per measurement and row of its run, N m: the fluid's inertia, signs included; empty where
    /// the run has no history.
    std::vector<std::vector<double>> inertia;
    /// The instruments with their ends and inertia as found: what `result` was fitted to.
    std::vector<Measurement> measurements;
    int rounds = 1; ///< fits until c_L and inertia stood
};

/// Ends and inertia depend on the law that is sought: both are found at a first fit's parameters
/// and again at the next one's until they stand (c_L with its slopes, so that once is mostly
/// enough).
/// @param measurements    one or several instruments, same fluid
/// @param converted       all rows by the instruments' conversions, as select_points gives them;
/// the
///                        starting values come from it
/// @param slip            fit a wall slip too; needs two gaps of different widths
/// Throws rheometry::fit::FitError, and Interrupted from the effects' progress.
[[nodiscard]] InstrumentFit fit_through(const rheometry::fit::Model& law,
                                        const std::vector<Measurement>& measurements,
                                        const rheometry::fit::FlowData& converted,
                                        const rheometry::fit::FitOptions& options, bool slip,
                                        const InstrumentEffects& effects = {.ends = false});

} // namespace searle::solvers::fit_instrument
