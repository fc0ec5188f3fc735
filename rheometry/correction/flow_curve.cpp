#include "rheometry/correction/flow_curve.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry {
namespace {

bool is_usable(double speed, double stress) {
    return std::isfinite(speed) && std::isfinite(stress) && speed * stress > 0.0;
}

struct Measurement {
    double log_omega;
    double log_stress;
    double weight;
};

/// Merges neighbours whose ln(omega) lies within `width` of the first one merged.
FlowCurve merged(std::span<const Measurement> sorted, double width) {
    FlowCurve curve;
    for (std::size_t first = 0; first < sorted.size();) {
        double omega = 0.0;
        double stress = 0.0;
        double weight = 0.0;
        std::size_t next = first;
        for (; next < sorted.size() && sorted[next].log_omega <= sorted[first].log_omega + width;
             ++next) {
            omega += sorted[next].weight * (sorted[next].log_omega - sorted[first].log_omega);
            stress += sorted[next].weight * sorted[next].log_stress;
            weight += sorted[next].weight;
        }
        curve.log_omega.push_back(sorted[first].log_omega + omega / weight);
        curve.log_stress.push_back(stress / weight);
        curve.weights.push_back(weight);
        first = next;
    }
    return curve;
}

std::vector<double> exponentials(const std::vector<double>& logarithms) {
    std::vector<double> values(logarithms.size());
    std::ranges::transform(logarithms, values.begin(), [](double x) { return std::exp(x); });
    return values;
}

} // namespace

std::vector<double> FlowCurve::omega() const { return exponentials(log_omega); }

std::vector<double> FlowCurve::stress() const { return exponentials(log_stress); }

std::optional<CurvePosition> FlowCurve::position_of(double speed, double stress) const {
    if (!is_usable(speed, stress))
        return std::nullopt;
    const double x = std::log(std::abs(speed));
    const auto above = std::ranges::upper_bound(log_omega, x);
    if (above == log_omega.begin())
        return CurvePosition{0, 0.0};
    const auto index = static_cast<std::size_t>(above - log_omega.begin()) - 1;
    if (index + 1 == size())
        return CurvePosition{index, 0.0};
    return CurvePosition{index, (x - log_omega[index]) / (log_omega[index + 1] - log_omega[index])};
}

FlowCurve merged_curve(std::span<const double> speeds, std::span<const double> stresses) {
    std::vector<Measurement> measurements;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (is_usable(speeds[i], stresses[i]))
            measurements.push_back(
                {std::log(std::abs(speeds[i])), std::log(std::abs(stresses[i])), 1.0});
    if (measurements.empty())
        return {};
    std::ranges::sort(measurements, {}, &Measurement::log_omega);
    const double range = measurements.back().log_omega - measurements.front().log_omega;
    return merged(measurements, std::max(1e-3, range / 400.0));
}

FlowCurve first_points(const FlowCurve& curve, std::size_t count) {
    const auto end = static_cast<std::ptrdiff_t>(count);
    return {{curve.log_omega.begin(), curve.log_omega.begin() + end},
            {curve.log_stress.begin(), curve.log_stress.begin() + end},
            {curve.weights.begin(), curve.weights.begin() + end}};
}

FlowCurve thinned(const FlowCurve& curve, std::size_t most) {
    if (curve.size() <= most)
        return curve;
    std::vector<Measurement> measurements(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i)
        measurements[i] = {curve.log_omega[i], curve.log_stress[i], curve.weights[i]};
    const double range = curve.log_omega.back() - curve.log_omega.front();
    return merged(measurements, range / static_cast<double>(most - 1));
}

} // namespace searle::rheometry
