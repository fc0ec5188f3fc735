#pragma once

#include "laws/contact/contact_spring.hpp"

#include <algorithm>
#include <cmath>

namespace searle::laws::contact {

/// Elastic spheres of one material: Hertz 1882 along the normal,
///     F_n = (4/3) E* sqrt(R* overlap^3) - gamma_n v_n,   E* = G / (1 - nu),
/// R* = r_1 r_2 / (r_1 + r_2), and across it Mindlin's stiffness without slip (1949, J. Appl. Mech.
/// 16, 259), k_t = 8 G* a = 4 G a / (2 - nu) with the radius of contact a = sqrt(R* overlap);
/// |F_t| <= friction |F_n| as in Hooke.
/// gamma_n = 2 sqrt(5/6) zeta sqrt(m_eff dF_n/d overlap) + damping: the restitution is the same at
/// every speed (Tsuji, Tanaka & Ishida 1992, Powder Technol. 71, 239) and zeta the one of a linear
/// pair (Antypov & Elliott 2011, Europhys. Lett. 94, 50004). gamma_t = gamma_n / 2.
struct Hertz {
    double shear_modulus{};    ///< G, Pa, > 0
    double poisson_ratio{};    ///< nu, -1 < nu < 0.5
    double damping_ratio{};    ///< zeta, 0 <= zeta < 1
    double damping{};          ///< a dashpot that does not follow from zeta, kg/s, >= 0
    double friction{};         ///< Coulomb coefficient, >= 0
    double rolling_friction{}; ///< >= 0

    static constexpr bool depends_on_radii = true;

    /// E*, Pa.
    [[nodiscard]] double contact_modulus() const { return shear_modulus / (1.0 - poisson_ratio); }

    [[nodiscard]] ContactSpring at(double overlap, double reduced_radius,
                                   double reduced_mass) const {
        const double contact_radius = std::sqrt(reduced_radius * std::max(overlap, 0.0));
        const double slope = 2.0 * contact_modulus() * contact_radius;
        constexpr double tsuji = 1.8257418583505537; // 2 sqrt(5/6)
        return {.normal = 2.0 / 3.0 * slope,
                .slope = slope,
                .tangential = 4.0 * shear_modulus / (2.0 - poisson_ratio) * contact_radius,
                .damping = tsuji * damping_ratio * std::sqrt(slope * reduced_mass) + damping};
    }
    /// Overlap at which the normal force is `force`, m.
    [[nodiscard]] double overlap_under(double force, double reduced_radius) const {
        return std::cbrt(std::pow(0.75 * force / contact_modulus(), 2) / reduced_radius);
    }
    /// Deepest overlap of an undamped head-on contact at `speed`, m:
    /// (15 m_eff v^2 / (16 E* sqrt(R*)))^(2/5).
    [[nodiscard]] double deepest_overlap(double speed, double reduced_radius,
                                         double reduced_mass) const {
        return std::pow(15.0 / 16.0 * reduced_mass * speed * speed /
                            (contact_modulus() * std::sqrt(reduced_radius)),
                        0.4);
    }
};

} // namespace searle::laws::contact
