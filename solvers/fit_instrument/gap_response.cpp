#include "solvers/fit_instrument/gap_response.hpp"

#include "solvers/radial/gauss_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::fit_instrument {
namespace {

using rheometry::fit::Model;

/// Below exp(-30) of the wall's rate nothing of the integral is left.
constexpr double negligible_range = 30.0;
/// As in radial::steady_gap_flow, but narrow enough for flow indices up to 2.
constexpr double first_panel = 2.5;
constexpr double panel_growth = 1.6;

/// Nodes and weights in ln(rate) over [low, high], dense near the top.
struct Nodes {
    std::vector<double> rates;
    std::vector<double> weights;
};

Nodes nodes_between(double low, double high) {
    const auto& rule = radial::gauss_rule<12>();
    Nodes nodes;
    double top = high;
    double width = first_panel;
    while (top > low) {
        const double bottom = std::max(low, top - width);
        const double half = 0.5 * (top - bottom);
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            nodes.rates.push_back(std::exp(0.5 * (top + bottom) + half * rule.node[k]));
            nodes.weights.push_back(half * rule.weight[k]);
        }
        top = bottom;
        width *= panel_growth;
    }
    return nodes;
}

/// The speeds and rates that belong to a rate at the inner wall.
struct Trial {
    double stress{};
    double outer_rate{};
    double speed{};       ///< slip included
    double speed_slope{}; ///< d speed / d stress
};

} // namespace

GapResponse GapCurve::at(std::size_t index, const Model& law, std::span<const double> search,
                         double slip, bool derivatives) const {
    const std::vector<double> values = law.values(search);
    const double omega = speeds_[index];
    const double excess_ratio = gap_.ratio_squared_minus_one();
    const double ratio_squared = 1.0 + excess_ratio;
    const double slip_per_stress =
        1.0 / gap_.inner_radius + 1.0 / (ratio_squared * gap_.outer_radius);
    const double yield = law.yield_stress(values);

    GapResponse response;
    // Slip alone carries the speed: nothing is sheared.
    if (slip > 0.0 && yield > 0.0 && slip * slip_per_stress * yield >= omega) {
        response.inner_stress = omega / (slip * slip_per_stress);
        response.partly_sheared = true;
        if (derivatives) {
            response.derivatives.assign(search.size(), 0.0);
            response.slip_derivative = -response.inner_stress / slip;
        }
        return response;
    }
    const auto range_of = [&](double log_rate, double outer) {
        const double floor = log_rate - negligible_range;
        return outer > 0.0 ? std::max(floor, std::log(outer)) : floor;
    };
    const auto trial = [&](double log_rate) {
        Trial result;
        const double inner = std::exp(log_rate);
        result.stress = law.stress(values, inner);
        result.outer_rate = law.rate(values, result.stress / ratio_squared);
        const Nodes nodes = nodes_between(range_of(log_rate, result.outer_rate), log_rate);
        for (std::size_t k = 0; k < nodes.rates.size(); ++k)
            result.speed +=
                0.5 * nodes.weights[k] * nodes.rates[k] * law.log_slope(values, nodes.rates[k]);
        result.speed += slip * slip_per_stress * result.stress;
        result.speed_slope =
            0.5 * (inner - result.outer_rate) / result.stress + slip * slip_per_stress;
        return result;
    };

    double low = -700.0;
    double high = 700.0;
    double log_rate = log_rate_[index] != 0.0
                          ? log_rate_[index]
                          : std::log(2.0 * omega * ratio_squared / excess_ratio);
    Trial found;
    bool settled = false;
    for (int iteration = 0; iteration < 100; ++iteration) {
        found = trial(log_rate);
        const double log_slope = law.log_slope(values, std::exp(log_rate));
        const double difference = std::log(found.speed / omega);
        const double slope = found.speed_slope * found.stress * log_slope / found.speed;
        if (!std::isfinite(difference) || !(slope > 0.0))
            break;
        (difference > 0.0 ? high : low) = log_rate;
        const double stress_step = std::abs(difference / slope) * log_slope;
        if (stress_step < 1e-12) {
            settled = true;
            break;
        }
        double next = log_rate - std::clamp(difference / slope, -5.0, 5.0);
        if (!(next > low && next < high))
            next = 0.5 * (std::max(low, log_rate - 5.0) + std::min(high, log_rate + 5.0));
        if (std::abs(next - log_rate) <= 1e-15 * std::abs(next)) {
            settled = true;
            break;
        }
        log_rate = next;
    }
    if (!settled) {
        response.inner_stress = std::numeric_limits<double>::quiet_NaN();
        log_rate_[index] = 0.0;
        return response;
    }
    log_rate_[index] = log_rate;
    response.inner_stress = found.stress;
    response.inner_rate = std::exp(log_rate);
    response.partly_sheared = found.outer_rate == 0.0 && yield > 0.0;
    if (!derivatives)
        return response;

    const Nodes nodes = nodes_between(range_of(log_rate, found.outer_rate), log_rate);
    std::vector<double> stresses(nodes.rates.size());
    std::vector<double> jacobian(nodes.rates.size() * search.size());
    law.stresses(search, nodes.rates, stresses, jacobian);
    response.derivatives.assign(search.size(), 0.0);
    for (std::size_t k = 0; k < nodes.rates.size(); ++k)
        for (std::size_t i = 0; i < search.size(); ++i)
            response.derivatives[i] += 0.5 * nodes.weights[k] * nodes.rates[k] *
                                       jacobian[k * search.size() + i] / stresses[k];
    for (double& derivative : response.derivatives)
        derivative /= found.speed_slope;
    response.slip_derivative = -slip_per_stress * found.stress / found.speed_slope;
    return response;
}

} // namespace searle::solvers::fit_instrument
