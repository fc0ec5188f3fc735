#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::drag {

/// Gidaspow's combination (1994, Multiphase Flow and Fluidization, table 2.1) of Ergun 1952 for
/// eps <= 0.8 and Wen & Yu 1966 above, per volume beta (u - v), here per particle (V / (1 - eps)):
/// Ergun   beta = 150 (1 - eps)^2 mu / (eps d^2) + 1.75 (1 - eps) rho |u - v| / d,
/// Wen-Yu  beta = 3/4 C_d eps (1 - eps) rho |u - v| eps^(-2.65) / d,
///         C_d = 24 / Re_p (1 + 0.15 Re_p^0.687) below Re_p = 1000, 0.44 above,
/// Re_p = rho d eps |u - v| / mu. These beta are those of Model A. Limit Re_p -> 0, eps -> 1:
/// Stokes. The two do not meet at eps = 0.8: the coefficient jumps there.
struct ErgunWenYu {
    double viscosity{}; ///< mu, Pa s
    double density{};   ///< rho, of the fluid, kg/m^3

    /// Force over slip velocity, kg/s. @param radius m  @param slip |u - v|, m/s, >= 0
    [[nodiscard]] double coefficient(double radius, double slip, double fluid_fraction) const {
        const double diameter = 2.0 * radius;
        const double volume = std::numbers::pi * diameter * diameter * diameter / 6.0;
        const double eps = fluid_fraction;
        const double reynolds = density * diameter * eps * slip / viscosity;
        const double ergun = 150.0 * (1.0 - eps) * viscosity / (eps * diameter * diameter) +
                             1.75 * density * slip / diameter;
        const double slow =
            24.0 * (1.0 + 0.15 * std::exp(0.687 * std::log(std::max(reynolds, 1e-300))));
        const double drag_times_reynolds = reynolds < 1000.0 ? slow : 0.44 * reynolds;
        const double wen_yu = 0.75 * drag_times_reynolds * viscosity *
                              std::exp(-2.65 * std::log(eps)) / (diameter * diameter);
        return volume * (eps <= 0.8 ? ergun : wen_yu);
    }
};

} // namespace searle::laws::drag
