#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::laws::drag {

/// Di Felice 1994, Int. J. Multiphase Flow 20, 153. With the interstitial slip |u - v|,
/// Re_p = rho d eps |u - v| / mu, C_d = (0.63 + 4.8 / sqrt(Re_p))^2 (Dalla Valle 1948) and
/// chi = 3.7 - 0.65 exp(-(1.5 - log10 Re_p)^2 / 2),
///     F = C_d rho pi r^2 |u - v| (u - v) eps^(2 - chi) / 2   (Model A; Model B: over eps).
/// Limit Re_p -> 0: 5.76 pi mu r eps^(-2.7), that is 0.96 of Stokes' drag for eps = 1, because
/// 4.8^2 = 23.04 stands in place of 24. Written as C_d Re_p, so that the limit needs no division.
/// Range: 0 < eps <= 1; the correlation was fitted for Re_p from 0.01 to 1e4.
struct DiFelice {
    double viscosity{}; ///< mu, Pa s
    double density{};   ///< rho, of the fluid, kg/m^3

    [[nodiscard]] double exponent(double reynolds) const {
        const double offset = 1.5 - std::log10(std::max(reynolds, 1e-30));
        return 3.7 - 0.65 * std::exp(-0.5 * offset * offset);
    }
    /// Force over slip velocity, kg/s. @param radius m  @param slip |u - v|, m/s, >= 0
    [[nodiscard]] double coefficient(double radius, double slip, double fluid_fraction) const {
        const double reynolds = 2.0 * density * radius * fluid_fraction * slip / viscosity;
        const double root = 0.63 * std::sqrt(reynolds) + 4.8;
        return 0.25 * root * root * std::numbers::pi * radius * viscosity *
               std::exp(std::log(fluid_fraction) * (1.0 - exponent(reynolds)));
    }
};

} // namespace searle::laws::drag
