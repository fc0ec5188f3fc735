#include "solvers/radial/annular_gap.hpp"

#include "solvers/radial/gauss_rule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::solvers::radial {
namespace {

/// Below exp(-30) of the wall's rate nothing of the integral is left in double precision's 1e-13.
constexpr double negligible_range = 30.0;
/// Panel next to the wall; with 12 points and the nearest pole of d ln tau / d ln rate at a
/// distance pi the rule's error is below 1e-13. Further panels may grow since exp(ln rate) shrinks.
constexpr double first_panel = 4.0;
constexpr double panel_growth = 1.5;
/// Not so where the law bends sharply: its poles stay as near however far from the wall.
constexpr double sharp_panel_growth = 1.1;

/// 1/2 integral of rate d ln(stress) over ln(rate) in [low, high].
template <class Law>
double speed_integral(const Law& law, double low, double high) {
    const auto& rule = gauss_rule<12>();
    const double panel_scale = first_panel / law.sharpness();
    double sum = 0.0;
    double top = high;
    double width = panel_scale;
    const double growth = law.sharpness() > 2.0 ? sharp_panel_growth : panel_growth;
    while (top > low) {
        const double bottom = std::max(low, top - width);
        const double half = 0.5 * (top - bottom);
        const double middle = 0.5 * (top + bottom);
        double panel = 0.0;
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            const double rate = std::exp(middle + half * rule.node[k]);
            panel += rule.weight[k] * rate * law.log_slope(rate);
        }
        sum += half * panel;
        top = bottom;
        width *= growth;
    }
    return 0.5 * sum;
}

template <class Law>
SteadyGapFlow solve(const AnnularGap& gap, const Law& law, double omega) {
    const double excess_ratio = gap.ratio_squared_minus_one();
    const double ratio_squared = 1.0 + excess_ratio;
    const double yield = law.yield_stress_value();

    // Rate at the outer wall for a given rate at the inner wall; the stress falls by delta^2.
    const auto outer_rate = [&](double inner_rate) {
        const double excess =
            (law.excess_stress(inner_rate) - yield * excess_ratio) / ratio_squared;
        return excess > 0.0 ? law.rate_at_excess(excess) : 0.0;
    };
    const auto speed = [&](double log_rate, double outer) {
        const double floor = log_rate - negligible_range;
        const double low = outer > 0.0 ? std::max(floor, std::log(outer)) : floor;
        return speed_integral(law, low, log_rate);
    };

    // omega <= rate_inner ln(delta), since the stress cannot fall by more than delta^2.
    double low = std::log(omega / (0.5 * std::log1p(excess_ratio)));
    double high = low + 1e4;
    double log_rate = std::max(low, std::log(2.0 * omega * ratio_squared / excess_ratio));
    double inner = std::exp(log_rate);
    double outer = 0.0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        inner = std::exp(log_rate);
        outer = outer_rate(inner);
        const double value = speed(log_rate, outer);
        const double log_slope = law.log_slope(inner);
        // d omega / d ln(tau_inner) = (rate_inner - rate_outer) / 2, exactly.
        const double slope = 0.5 * (inner - outer) * log_slope / value;
        const double difference = std::log(value / omega);
        (difference > 0.0 ? high : low) = log_rate;
        double next = log_rate - difference / slope;
        if (!(next >= low && next <= high)) {
            next = 0.5 * (low + std::min(high, low + 10.0));
        }
        const double step = next - log_rate;
        log_rate = next;
        // The torque moves by log_slope * step; Newton's next step would be its square.
        if (std::abs(step) * std::max(log_slope, 1e-2) < 1e-9) {
            break;
        }
    }
    inner = std::exp(log_rate);
    outer = outer_rate(inner);

    SteadyGapFlow flow;
    flow.inner_wall_rate = inner;
    flow.outer_wall_rate = outer;
    flow.inner_wall_stress = law.stress(inner);
    flow.torque_per_length =
        2.0 * std::numbers::pi * gap.inner_radius * gap.inner_radius * flow.inner_wall_stress;
    flow.partly_sheared = outer == 0.0 && yield > 0.0;
    flow.yield_radius = flow.partly_sheared
                            ? gap.inner_radius * std::sqrt(1.0 + law.excess_stress(inner) / yield)
                            : gap.outer_radius;
    // In a narrow gap the interval in ln(rate) is the difference of two near numbers.
    const double interval =
        outer > 0.0 ? std::min(negligible_range, log_rate - std::log(outer)) : negligible_range;
    flow.relative_error =
        std::max(1e-11, 4e-15 * std::max(1.0, std::abs(log_rate)) / std::max(interval, 1e-15));
    return flow;
}

} // namespace

SteadyGapFlow steady_gap_flow(const AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                              double omega) {
    return std::visit([&](const auto& chosen) { return solve(gap, chosen, omega); }, law);
}

} // namespace searle::solvers::radial
