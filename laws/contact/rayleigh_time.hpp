#pragma once

#include <cmath>
#include <numbers>

namespace searle::laws::contact {

/// Time that a Rayleigh wave takes through a sphere, s:
/// pi r sqrt(density / shear_modulus) / (0.163 nu + 0.8766).
/// Explicit steps of elastic contacts take 0.1 ... 0.3 of it (Li, Xu & Thornton 2005, Powder
/// Technol. 160, 219).
/// @param radius m  @param density kg/m^3  @param shear_modulus Pa  @param poisson_ratio -1 ... 0.5
[[nodiscard]] inline double rayleigh_time(double radius, double density, double shear_modulus,
                                          double poisson_ratio) {
    return std::numbers::pi * radius * std::sqrt(density / shear_modulus) /
           (0.163 * poisson_ratio + 0.8766);
}

} // namespace searle::laws::contact
