#pragma once

#include "laws/lubrication/near_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::lubrication {

/// Torque of a sphere that turns about the normal of a plane wall, over that of a lone one, less 1
/// (Jeffery 1915, Proc. London Math. Soc. 14, 327): sum of (sinh alpha / sinh n alpha)^3 from n =
/// 2, cosh alpha = 1 + h / a; zeta(3) - 1 at contact. Twelve terms, within 4e-3.
[[nodiscard]] inline double twist_beside_wall(double gap_over_radius) {
    const double alpha = std::acosh(1.0 + gap_over_radius);
    double sum = 0.0;
    for (int n = 2; n <= 13; ++n) {
        const double ratio =
            alpha > 1e-6 ? std::sinh(alpha) / std::sinh(n * alpha) : 1.0 / static_cast<double>(n);
        sum += ratio * ratio * ratio;
    }
    return sum;
}

/// The film between a sphere and a plane wall, as near_contact.hpp has it between two spheres, with
/// the wall as the second, xi = h / a: the limit of r_2 -> infinity, but for the scale of the
/// logarithms (theirs is the mean radius). The lever of the slip is the sphere's radius:
///     squeeze 6 pi mu a (1/xi + ln(1/xi)/5)        (Cox & Brenner 1967, Chem. Eng. Sci. 22, 1753)
///     force of sliding 6 pi mu a 8/15 ln(1/xi), torque of turning 8 pi mu a^3 2/5 ln(1/xi), of one
///     by the other 8 pi mu a^2 1/10 ln(1/xi)       (Goldman, Cox & Brenner 1967, ibid. 22, 637)
/// With Stokes' drag the sphere by itself has 1 and 1 beside the logarithms of sliding and turning,
/// for 0.9543 and 0.3709 (Chaoui & Feuillebois 2003, Q. J. Mech. Appl. Math. 56, 381). What is left
/// out is that a shear flow pushes a sphere held near a wall 1.7 times as hard as Stokes' drag
/// (Goldman, Cox & Brenner 1967, part II, ibid. 653): a lone sphere beside a wall moves 30 to 35 %
/// slower than theirs. In a dense layer its neighbours decide.
/// @param gap m, > 0  @param viscosity Pa s
[[nodiscard]] inline Film wall_film(double gap, double radius, double viscosity, Squeeze terms) {
    constexpr double pi = std::numbers::pi;
    const double xi = gap / radius;
    const double log = std::max(-std::log(xi), 0.0);
    const double unit = pi * viscosity * radius;
    Film out;
    out.squeeze = 6.0 * unit * (1.0 / xi + (terms == Squeeze::both ? 0.2 * log : 0.0));
    out.shear = 3.2 * unit * log;
    out.mixed = -2.4 * unit * radius * log;
    out.pump = 4.8 * unit * radius * radius * log;
    out.twist = 8.0 * unit * radius * radius * twist_beside_wall(xi);
    return out;
}

} // namespace searle::laws::lubrication
