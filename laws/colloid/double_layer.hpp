#pragma once

#include "laws/exponential.hpp"

#include <cmath>
#include <numbers>

namespace searle::laws::colloid {

inline constexpr double vacuum_permittivity = 8.8541878128e-12; ///< F/m, CODATA 2018
inline constexpr double boltzmann = 1.380649e-23;               ///< J/K, exact
inline constexpr double elementary_charge = 1.602176634e-19;    ///< C, exact
inline constexpr double avogadro = 6.02214076e23;               ///< 1/mol, exact

/// Repulsion of the electric double layers of two spheres of one surface potential, h their surface
/// distance, kappa a >> 1. Both forms have the prefactor
///     Z = 4 pi eps eps_0 psi^2 r_i r_j / (r_i + r_j), J.
/// Valid for potentials up to some 50 mV (linear Poisson-Boltzmann) and kappa a above about 5.
struct DoubleLayer {
    double permittivity{};      ///< eps eps_0, F/m
    double potential{};         ///< psi, V
    double inverse_thickness{}; ///< kappa, 1/m, > 0

    [[nodiscard]] double prefactor(double r_i, double r_j) const {
        return 4.0 * std::numbers::pi * permittivity * potential * potential * (r_i * r_j) /
               (r_i + r_j);
    }
};

/// Linear superposition: E = Z exp(-kappa h). Equal spheres: 2 pi eps eps_0 a psi^2 exp(-kappa h).
struct WeakOverlap : DoubleLayer {
    [[nodiscard]] double energy(double h, double r_i, double r_j) const {
        return prefactor(r_i, r_j) * std::exp(-inverse_thickness * h);
    }
    /// Force that pushes apart, N.
    [[nodiscard]] double repulsion(double h, double r_i, double r_j) const {
        return prefactor(r_i, r_j) * inverse_thickness * exponential(-inverse_thickness * h);
    }
};

/// Constant potential, Hogg, Healy & Fuerstenau 1966, Trans. Faraday Soc. 62, 1638:
/// E = Z ln(1 + exp(-kappa h)). Limits: weak overlap for kappa h >> 1; Z ln 2 at contact.
struct ConstantPotential : DoubleLayer {
    [[nodiscard]] double energy(double h, double r_i, double r_j) const {
        return prefactor(r_i, r_j) * std::log1p(std::exp(-inverse_thickness * h));
    }
    [[nodiscard]] double repulsion(double h, double r_i, double r_j) const {
        const double decay = exponential(-inverse_thickness * h);
        return prefactor(r_i, r_j) * inverse_thickness * decay / (1.0 + decay);
    }
};

/// Debye length of a 1:1 electrolyte, m: sqrt(eps eps_0 k T / (2 N_A e^2 I)).
/// @param ionic_strength mol/m^3, > 0  @param temperature K
[[nodiscard]] inline double debye_length(double relative_permittivity, double temperature,
                                         double ionic_strength) {
    return std::sqrt(relative_permittivity * vacuum_permittivity * boltzmann * temperature /
                     (2.0 * avogadro * elementary_charge * elementary_charge * ionic_strength));
}

} // namespace searle::laws::colloid
