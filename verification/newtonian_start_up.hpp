#pragma once

#include <vector>

namespace searle::verification {

/// Exact Newtonian ramp from rest, omega = beta t, of an endless annulus whose inner wall turns, or
/// of a plane gap with one moving wall: eta_apparent / eta = 1 + [T - sum_k s_k exp(-lambda_k t)] /
/// t.
///
/// From the step response by separation of variables: the modes of the annulus are
/// Z(r) = J1(kappa r) Y1(kappa b) - Y1(kappa r) J1(kappa b) with Z(a) = 0, and
/// s_k = T_k = |c_k| / (F_steady lambda_k), T = sum_k T_k = g'(a) / (-2B / a^2) in closed form.
/// Independent of the transient solver: no grid, no time step.
class NewtonianStartUp {
public:
    /// Annulus inner < outer, m; kinematic viscosity m^2/s. `modes` terms are kept: exact to 1e-12
    /// for t > 30 width^2 / (viscosity pi^2 modes^2).
    static NewtonianStartUp annulus(double inner, double outer, double kinematic_viscosity,
                                    int modes);
    /// Plane gap: T = h^2 / (3 nu).
    static NewtonianStartUp plane(double gap, double kinematic_viscosity, int modes);

    /// eta_apparent / eta at the moving wall at time t after the ramp began, t > 0.
    [[nodiscard]] double viscosity_ratio(double time) const;
    /// T, s.
    [[nodiscard]] double lag() const { return lag_; }

private:
    double lag_{};
    std::vector<double> decay_; ///< lambda_k, 1/s
    std::vector<double> share_; ///< s_k, s
};

/// T by the closed form of the linear ramp, s, > 0 (docs/radial.md, eq. 7), at the wall that turns:
/// the inner one, or the outer one with the inner at rest. Tends to d^2 / (3 nu) for a narrow gap.
[[nodiscard]] double annulus_lag(double inner, double outer, double kinematic_viscosity,
                                 bool outer_wall_moves = false);

} // namespace searle::verification
