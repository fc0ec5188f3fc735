#pragma once

#include <numbers>

namespace searle::laws::drag {

/// Stokes 1851: a sphere alone in creeping flow. Force 6 pi mu r (u - v), torque
/// 8 pi mu r^3 (vorticity / 2 - omega).
struct Stokes {
    double viscosity{}; ///< mu, Pa s
    double density{};   ///< of the fluid, kg/m^3; not used

    /// Force over slip velocity, kg/s. @param radius m. Slip and fluid fraction have no part.
    [[nodiscard]] double coefficient(double radius, double /*slip*/,
                                     double /*fluid_fraction*/) const {
        return 6.0 * std::numbers::pi * viscosity * radius;
    }
};

/// Torque over slip in angular velocity, kg m^2/s.
[[nodiscard]] inline double rotational_coefficient(double viscosity, double radius) {
    return 8.0 * std::numbers::pi * viscosity * radius * radius * radius;
}

} // namespace searle::laws::drag
