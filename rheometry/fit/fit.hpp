#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/forward_model.hpp"
#include "rheometry/fit/model.hpp"

#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// Fits any forward model: the best of the searches from all `starts`, then intervals and
/// statistics. Warnings that need to know what was measured are left to the caller.
/// @param observed    as many as the forward model predicts
/// @param deviations  standard deviations for Weighting::custom, else empty
/// @param starts      SI values, at least one list
/// Throws FitError when there are fewer points than parameters to be found, or no start leads
/// anywhere.
[[nodiscard]] FitResult fit_forward(const ForwardModel& forward, std::span<const double> observed,
                                    std::span<const double> deviations,
                                    const std::vector<Parameter>& parameters,
                                    const std::vector<std::vector<double>>& starts,
                                    const FitOptions& options);

/// Fits a flow law to a flow curve. Starts come from the data and from the laws that this one
/// contains, so that none of those can fit better. Throws FitError.
[[nodiscard]] FitResult fit_flow_curve(const Model& model, const FlowData& data,
                                       const FitOptions& options);

/// The same for several laws, best AICc first (a law that has no finite AICc comes last, by its sum
/// of squares). Laws for which there are too few points are left out; FitError when none remains.
[[nodiscard]] std::vector<FitResult> fit_all(std::span<const Model> laws, const FlowData& data,
                                             const FitOptions& options);

/// The parameters of a law with the options' bounds. Throws FitError for a key that the law does
/// not have and for bounds outside its definition, unless `ignore_unknown`.
[[nodiscard]] std::vector<Parameter> bounded_parameters(const Model& model, const DataScale& scale,
                                                        const FitOptions& options,
                                                        bool ignore_unknown = false);

} // namespace searle::rheometry::fit
