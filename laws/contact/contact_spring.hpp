#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::contact {

/// What a contact law is at one overlap of one pair.
struct ContactSpring {
    double normal{};     ///< normal force without damping over the overlap, N/m
    double slope{};      ///< its derivative by the overlap, N/m
    double tangential{}; ///< stiffness of the tangential spring, N/m
    double damping{};    ///< dashpot along the normal, kg/s

    /// Half a period of the pair on a spring of this slope and with this dashpot, s: the duration
    /// of a head-on contact where the slope does not change. Infinite where it is overdamped.
    [[nodiscard]] double duration(double reduced_mass) const {
        const double discriminant = 4.0 * slope * reduced_mass - damping * damping;
        return 2.0 * std::numbers::pi * reduced_mass / std::sqrt(std::max(discriminant, 0.0));
    }
};

/// zeta = -ln e / sqrt(pi^2 + ln^2 e), the share of the critical damping that gives a restitution
/// e, the speed after over the speed before a head-on contact that ends when the overlap is back
/// at zero. It solves e = exp(-pi zeta / sqrt(1 - zeta^2)).
/// @param restitution 0 < e <= 1. Limits: 0 for e = 1, towards 1 (critical) for e -> 0.
[[nodiscard]] inline double damping_ratio(double restitution) {
    const double loss = -std::log(restitution);
    return loss / std::sqrt(std::numbers::pi * std::numbers::pi + loss * loss);
}

} // namespace searle::laws::contact
