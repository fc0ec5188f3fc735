#include "rheometry/fit/prediction.hpp"

#include <cmath>
#include <limits>

namespace searle::rheometry::fit {

std::vector<PredictedPoint> predict(const Model& model, const FitResult& result,
                                    const FlowData& data, std::span<const double> rates) {
    const std::size_t count = result.search.size();
    std::vector<double> stresses(rates.size());
    std::vector<double> jacobian(rates.size() * count);
    model.stresses(result.search, rates, stresses, jacobian);
    const double quantile = student_t95(result.degrees_of_freedom);
    std::vector<PredictedPoint> points;
    for (std::size_t k = 0; k < rates.size(); ++k) {
        double variance =
            result.search_covariance.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
        for (std::size_t i = 0; i < count && !result.search_covariance.empty(); ++i)
            for (std::size_t j = 0; j < count; ++j)
                variance += jacobian[k * count + i] * result.search_covariance[i * count + j] *
                            jacobian[k * count + j];
        const double relative = variance / (stresses[k] * stresses[k]);
        // Scatter of a point: the residuals' deviation times what a residual is measured in.
        double scatter = result.residual_deviation;
        if (result.weighting == Weighting::absolute)
            scatter *= result.units.front() / stresses[k];
        else if (result.weighting == Weighting::custom) // as the nearest point's
            scatter *= result.units[k * (result.units.size() - 1) /
                                    std::max<std::size_t>(1, rates.size() - 1)] /
                       stresses[k];
        const double curve = std::exp(quantile * std::sqrt(relative));
        const double point = std::exp(quantile * std::sqrt(relative + scatter * scatter));
        points.push_back(
            {.rate = rates[k],
             .stress = stresses[k],
             .confidence_low = stresses[k] / curve,
             .confidence_high = stresses[k] * curve,
             .prediction_low = stresses[k] / point,
             .prediction_high = stresses[k] * point,
             .extrapolated = rates[k] < data.rates.front() || rates[k] > data.rates.back()});
    }
    return points;
}

FitResult law_part(const FitResult& result, std::size_t parameters, double stress_per_observation,
                   std::span<const double> rates) {
    FitResult part = result;
    const std::size_t all = result.search.size();
    const auto cut = [&](const std::vector<double>& matrix) {
        std::vector<double> kept;
        for (std::size_t i = 0; i < parameters && !matrix.empty(); ++i)
            for (std::size_t k = 0; k < parameters; ++k)
                kept.push_back(matrix[i * all + k]);
        return kept;
    };
    part.search.resize(parameters);
    part.estimates.resize(parameters);
    part.search_covariance = cut(result.search_covariance);
    part.covariance = cut(result.covariance);
    part.correlation = cut(result.correlation);
    for (double& unit : part.units)
        unit *= stress_per_observation;
    part.present_rates.assign(rates.begin(), rates.end());
    return part;
}

std::vector<double> spread_rates(double low, double high, std::size_t count) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < count; ++i)
        rates.push_back(i + 1 == count ? high
                                       : low * std::pow(high / low, double(i) / double(count - 1)));
    return rates;
}

} // namespace searle::rheometry::fit
