#pragma once

#include "laws/contact/contact_spring.hpp"

#include <cmath>
#include <numbers>

namespace searle::laws::contact {

/// Restitution of a head-on pair whose dashpot is `damping` (kg/s), stiffness k (N/m) and reduced
/// mass m_eff (kg); 0 for a dashpot at or above the critical one.
[[nodiscard]] inline double restitution_of(double damping, double stiffness, double reduced_mass) {
    const double discriminant = 4.0 * stiffness * reduced_mass - damping * damping;
    return discriminant > 0.0 ? std::exp(-std::numbers::pi * damping / std::sqrt(discriminant))
                              : 0.0;
}

/// Linear springs and dashpots, Cundall & Strack 1979, Geotechnique 29, 47:
/// normal  F_n = k_n overlap - gamma_n v_n (v_n > 0: separating; it may pull shortly before the
/// two part), tangential F_t = -k_t s - gamma_t v_t with |F_t| <= friction |F_n|; s is the sum of
/// v_t dt, cut back to the limit while the contact slides.
/// All of a pair: gamma_n = 2 zeta sqrt(k_n m_eff) + damping, gamma_t = gamma_n / 2
/// (Silbert et al. 2001, Phys. Rev. E 64, 051302).
struct Hooke {
    double normal_stiffness{};     ///< k_n, N/m, > 0
    double tangential_stiffness{}; ///< k_t, N/m, >= 0
    double damping_ratio{};        ///< zeta, 0 <= zeta < 1
    double damping{};              ///< a dashpot that does not follow from zeta, kg/s, >= 0
    double friction{};             ///< Coulomb coefficient, >= 0
    double rolling_friction{};     ///< >= 0

    static constexpr bool depends_on_radii = false;

    [[nodiscard]] ContactSpring at(double /*overlap*/, double /*reduced_radius*/,
                                   double reduced_mass) const {
        return {.normal = normal_stiffness,
                .slope = normal_stiffness,
                .tangential = tangential_stiffness,
                .damping =
                    2.0 * damping_ratio * std::sqrt(normal_stiffness * reduced_mass) + damping};
    }
    /// Overlap at which the normal force is `force`, m.
    [[nodiscard]] double overlap_under(double force, double /*reduced_radius*/) const {
        return force / normal_stiffness;
    }
    /// Duration of a head-on contact, s.
    [[nodiscard]] double duration(double reduced_mass) const {
        return at(0.0, 0.0, reduced_mass).duration(reduced_mass);
    }
};

} // namespace searle::laws::contact
