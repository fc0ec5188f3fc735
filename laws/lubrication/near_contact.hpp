#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::lubrication {

/// Resistance of the fluid film between two near spheres, the part that grows as they approach
/// (Jeffrey & Onishi 1984, J. Fluid Mech. 139, 261), lambda = r_2 / r_1, xi = 2 h / (r_1 + r_2):
///     squeeze  X_A = g_1 / xi + g_2 ln(1/xi),  g_1 = 2 l^2 / (1+l)^3, g_2 = l (1 + 7 l + l^2) / (5
///     (1+l)^3) shear    Y_A = 4 l (2 + l + 2 l^2) / (15 (1+l)^3) ln(1/xi) rotation Y_C = 2 l / (5
///     (1+l)) ln(1/xi)
/// in units of 6 pi mu r_1 and 8 pi mu r_1^3; section 5 of theirs, equations (3.17), (4.15),
/// (7.10).
///
/// Written with motions that a rigid pair does not have, so that a rigid pair feels nothing: the
/// slip at the contact s = U_2 - U_1 - (l_1 W_1 + l_2 W_2) x n across the line n of centres, the
/// rolling d = (W_2 - W_1) x n, the squeeze (U_2 - U_1).n and the twist (W_2 - W_1).n. Power lost:
///     squeeze v_n^2 + shear s^2 + 2 mixed s.d + pump d^2 + twist w_n^2.
/// Shear, mixed and pump follow from Y_A, Y_C of both spheres; Y_B and Y_C12 are then theirs, too.
/// With the drag of the spheres alone (Stokes) equal spheres have X_A11 = 1 + ..., where the full
/// solution has 0.9954 + ..., and Y_A11 = 1 + ... for 0.9983 + ....
struct Film {
    double squeeze{}; ///< N s/m
    double shear{};   ///< N s/m
    double mixed{};   ///< N s
    double pump{};    ///< N s m
    double twist{};   ///< N s m
};

/// How much of the squeezing film is taken.
enum class Squeeze {
    leading, ///< g_1 / xi: the leading term, as the other modes have theirs
    both     ///< g_1 / xi + g_2 ln(1/xi)
};

/// @param gap       h, m, > 0  @param viscosity Pa s
/// Valid for xi << 1; used up to 1 it stays positive.
[[nodiscard]] inline Film film(double gap, double r_1, double r_2, double viscosity,
                               Squeeze terms) {
    constexpr double pi = std::numbers::pi;
    constexpr double zeta_3 = 1.2020569031595942;
    const double xi = 2.0 * gap / (r_1 + r_2);
    const double log = std::max(-std::log(xi), 0.0);
    const double l = r_2 / r_1;
    const double p = 1.0 + l;
    Film out;
    out.squeeze = 6.0 * pi * viscosity * r_1 * 2.0 * l * l / (p * p * p) / xi;
    if (terms == Squeeze::both)
        out.squeeze +=
            6.0 * pi * viscosity * r_1 * l * (1.0 + 7.0 * l + l * l) / (5.0 * p * p * p) * log;
    out.shear =
        6.0 * pi * viscosity * r_1 * 4.0 * l * (2.0 + l + 2.0 * l * l) / (15.0 * p * p * p) * log;
    const double turn_1 = 8.0 * pi * viscosity * r_1 * r_1 * r_1 * 2.0 * l / (5.0 * p) * log;
    const double turn_2 = 8.0 * pi * viscosity * r_2 * r_2 * r_2 * 2.0 / (5.0 * p) * log;
    out.mixed = 0.5 * (turn_1 - turn_2 - out.shear * (r_1 * r_1 - r_2 * r_2)) / (r_1 + r_2);
    out.pump = turn_1 - out.shear * r_1 * r_1 - 2.0 * out.mixed * r_1;
    const double sum = r_1 + r_2;
    out.twist = std::max(0.0, pi * viscosity * sum * sum * sum *
                                  (8.0 * l * l * l / std::pow(p, 6) * zeta_3 -
                                   4.0 * l * l / std::pow(p, 4) * xi * log));
    return out;
}

} // namespace searle::laws::lubrication
