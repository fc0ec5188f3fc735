#include "rheometry/correction/rotor_rate.hpp"

#include "rheometry/conversion/conversion.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry {
namespace {

struct RatesOf {
    std::span<const double> speeds;
    std::span<const double> stresses;

    WallRates operator()(const geometry::ConcentricCylinders& gap) const {
        return wall_rates(speeds, stresses, gap.radius_ratio());
    }
    WallRates operator()(const geometry::DinBob& bob) const {
        return wall_rates(speeds, stresses, bob.radius_ratio());
    }
    WallRates operator()(const geometry::DoubleGap& gap) const {
        const double outer = gap.radius_ratio() - 1.0;
        const double inner = gap.inner_gap() / gap.radii[0];
        if (std::abs(inner - outer) < 0.05 * outer)
            return wall_rates(speeds, stresses, gap.radius_ratio());
        return no_rates(speeds.size());
    }
    WallRates operator()(const geometry::Box& box) const {
        WallRates result;
        for (const double speed : speeds)
            result.rows.push_back({speed / box.gap, 0.0, GapBranch::sheared});
        return result;
    }
};

} // namespace

RotorRates rotor_rates(const geometry::Instrument& instrument, double end_factor,
                       std::span<const double> speeds, std::span<const double> torques) {
    const double stress_per_torque = rotor_wall_stress_per_torque(instrument, end_factor);
    RotorRates result;
    result.stresses.resize(torques.size());
    std::ranges::transform(torques, result.stresses.begin(),
                           [=](double torque) { return stress_per_torque * torque; });
    result.rates = std::visit(RatesOf{speeds, result.stresses}, instrument);
    return result;
}

} // namespace searle::rheometry
