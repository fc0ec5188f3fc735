#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"

#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// The fitted curve at one rate, with its 95 % bands.
struct PredictedPoint {
    double rate{};   ///< 1/s
    double stress{}; ///< Pa
    /// Where the curve itself lies.
    double confidence_low{};
    double confidence_high{};
    /// Where a further measured point would lie.
    double prediction_low{};
    double prediction_high{};
    bool extrapolated = false; ///< outside the rates of the data
};

/// Bands by the linearised law at the optimum, in ln(stress), so that they stay above 0. Their ends
/// are NaN where the fit has no covariance.
/// @param result  of fit_flow_curve with the same data
/// @param rates   1/s, > 0
[[nodiscard]] std::vector<PredictedPoint> predict(const Model& model, const FitResult& result,
                                                  const FlowData& data,
                                                  std::span<const double> rates);

/// A fit through an instrument as if the law had been fitted to a flow curve: without parameters
/// beyond the law's own (slip), and with what a residual is measured in as a stress.
/// @param stress_per_observation  Pa per unit observed (N m)
/// @param rates                   1/s, of the points
[[nodiscard]] FitResult law_part(const FitResult& result, std::size_t parameters,
                                 double stress_per_observation, std::span<const double> rates);

/// Rates with equal steps in the logarithm, both ends exact.
[[nodiscard]] std::vector<double> spread_rates(double low, double high, std::size_t count);

} // namespace searle::rheometry::fit
