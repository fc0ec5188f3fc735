#include "solvers/stability/sheared_layer.hpp"

#include <cmath>

namespace searle::solvers::stability {
namespace {

/// Fluid of less than this share of the fluidity at the bob is taken for rigid.
constexpr double rigid_fluidity = 1e-8;

/// Stress and rate at a distance in ln r from the outer end of a layer, where the stress exceeds
/// the yield stress by `end_excess`. Stresses fall as r^-2; nothing cancels near a yield surface.
template <class Law>
struct Profile {
    const Law& law;
    double end_excess;

    [[nodiscard]] double excess(double remaining) const {
        return end_excess * std::exp(2.0 * remaining) +
               law.yield_stress_value() * std::expm1(2.0 * remaining);
    }
    [[nodiscard]] double stress(double remaining) const {
        return law.yield_stress_value() + excess(remaining);
    }
    [[nodiscard]] double rate(double remaining) const {
        return law.rate_at_excess(excess(remaining));
    }
    [[nodiscard]] double fluidity(double remaining) const {
        return rate(remaining) / stress(remaining);
    }
};

template <class Law>
ShearedLayer tabulate(const radial::AnnularGap& gap, const Law& law,
                      const radial::SteadyGapFlow& flow, double speed, int nodes) {
    const double yield = law.yield_stress_value();
    ShearedLayer layer;
    layer.wall_rate = flow.inner_wall_rate;
    layer.wall_viscosity = flow.inner_wall_stress / flow.inner_wall_rate;
    layer.depth = flow.partly_sheared
                      ? 0.5 * std::log1p(double{law.excess_stress(flow.inner_wall_rate)} / yield)
                      : std::log1p(gap.width() / gap.inner_radius);
    Profile<Law> profile{
        law, flow.outer_wall_rate > 0.0 ? double{law.excess_stress(flow.outer_wall_rate)} : 0.0};

    const double least = rigid_fluidity / layer.wall_viscosity;
    if (!(profile.fluidity(0.0) >= least)) {
        // In the logarithm of the distance, which may be any part of the layer.
        double rigid = 1e-15 * layer.depth;
        double fluid = layer.depth;
        while (fluid > 1.001 * rigid) {
            const double middle = std::sqrt(rigid * fluid);
            (profile.fluidity(middle) >= least ? fluid : rigid) = middle;
        }
        profile.end_excess = profile.excess(fluid);
        layer.depth -= fluid;
    }

    layer.grid = &layer_grid(nodes);
    layer.rate.resize(nodes);
    layer.secant.resize(nodes);
    layer.tangent.resize(nodes);
    for (int i = 0; i < nodes; ++i) {
        const double remaining = layer.depth * layer.grid->remaining[i];
        const double rate = profile.rate(remaining);
        layer.rate[i] = rate;
        layer.secant[i] = profile.stress(remaining) / rate / layer.wall_viscosity;
        layer.tangent[i] = layer.secant[i] * double{law.log_slope(rate)};
    }
    const double covered = layer.depth * layer.grid->weights.dot(layer.rate.matrix());
    layer.covered_speed = covered / speed;
    layer.rate /= covered;
    layer.rotation = layer.depth * (layer.grid->to_outer * layer.rate.matrix()).array();
    return layer;
}

} // namespace

ShearedLayer sheared_layer(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                           const radial::SteadyGapFlow& flow, double speed, int nodes) {
    return std::visit([&](const auto& chosen) { return tabulate(gap, chosen, flow, speed, nodes); },
                      law);
}

} // namespace searle::solvers::stability
