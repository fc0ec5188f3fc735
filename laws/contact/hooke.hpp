#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::contact {

/// Damping of a linear spring-dashpot pair that gives a restitution e:
/// zeta = -ln e / sqrt(pi^2 + ln^2 e), the dashpot being gamma = 2 zeta sqrt(k m_eff).
/// It solves e = exp(-pi gamma / sqrt(4 k m_eff - gamma^2)), the speed after over the speed before
/// a head-on contact that ends when the overlap is back at zero.
/// @param restitution 0 < e <= 1. Limits: 0 for e = 1, towards 1 (critical) for e -> 0.
[[nodiscard]] inline double damping_ratio(double restitution) {
    const double loss = -std::log(restitution);
    return loss / std::sqrt(std::numbers::pi * std::numbers::pi + loss * loss);
}

/// Restitution of a head-on pair whose dashpot is `damping` (kg/s), stiffness k (N/m) and reduced
/// mass m_eff (kg); 0 for a dashpot at or above the critical one.
[[nodiscard]] inline double restitution_of(double damping, double stiffness, double reduced_mass) {
    const double discriminant = 4.0 * stiffness * reduced_mass - damping * damping;
    return discriminant > 0.0 ? std::exp(-std::numbers::pi * damping / std::sqrt(discriminant))
                              : 0.0;
}

/// Linear springs and dashpots, Cundall & Strack 1979, Geotechnique 29, 47:
/// normal  F_n = k_n overlap - gamma_n v_n (v_n > 0: separating),
/// tangential F_t = -k_t s - gamma_t v_t with |F_t| <= friction |F_n|; s is the sum of v_t dt, cut
/// back to the limit while the contact slides.
/// All of a pair: gamma_n = 2 zeta sqrt(k_n m_eff) + damping, gamma_t = gamma_n / 2
/// (Silbert et al. 2001, Phys. Rev. E 64, 051302).
struct Hooke {
    double normal_stiffness{};     ///< k_n, N/m, > 0
    double tangential_stiffness{}; ///< k_t, N/m, >= 0
    double damping_ratio{};        ///< zeta, 0 <= zeta < 1
    double damping{};              ///< a dashpot that does not follow from zeta, kg/s, >= 0
    double friction{};             ///< Coulomb coefficient, >= 0
    double rolling_friction{};     ///< >= 0

    [[nodiscard]] double normal_damping(double reduced_mass) const {
        return 2.0 * damping_ratio * std::sqrt(normal_stiffness * reduced_mass) + damping;
    }
    /// Force that pushes the two apart, N; may pull shortly before they part.
    [[nodiscard]] double normal_force(double overlap, double separating_speed,
                                      double pair_damping) const {
        return normal_stiffness * overlap - pair_damping * separating_speed;
    }
    /// Duration of a head-on contact, s.
    [[nodiscard]] double duration(double reduced_mass) const {
        const double gamma = normal_damping(reduced_mass);
        const double discriminant = 4.0 * normal_stiffness * reduced_mass - gamma * gamma;
        return 2.0 * std::numbers::pi * reduced_mass / std::sqrt(std::max(discriminant, 0.0));
    }
};

} // namespace searle::laws::contact
