#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"

namespace searle::solvers {

enum class TurningWall { inner, outer };

/// Lag time T of a Newtonian fluid in an annulus, s: in a ramp from rest, omega = beta t, the
/// torque on the turning wall shows the apparent viscosity eta (1 + T / t) once the start transient
/// is over. T is the moment of inertia that the steady flow drags along over its viscous
/// resistance:
///   T = (delta^2 - 1) / (2 delta^2 nu) integral of phi^2 r^3 dr / R_inner^2,  phi = Omega / omega,
/// equal to g'(R_bob) / (-2 B / R_bob^2) of docs/plan.md by Green's identity but free of the
/// cancellation that the closed form with ln(delta) has in a narrow gap. Relative error 1e-13.
/// Limit of a narrow gap: d^2 / (3 nu).
/// @param kinematic_viscosity  m^2/s, > 0
[[nodiscard]] double newtonian_lag_time(const radial::AnnularGap& gap, double kinematic_viscosity,
                                        TurningWall wall = TurningWall::inner);

/// How a steady flow answers to a slow or sudden change of the speed, to first order.
struct GapResponse {
    /// Extra torque on the turning wall per angular acceleration, long after the last kink, per
    /// length: kg m. For the box: force per acceleration and area, kg/m^2.
    double inertia{};
    /// Time constant of the slowest decaying disturbance between the two walls, s.
    double decay_time{};
};

/// The response of the flow `steady` of a fluid in an annulus, linearised with the tangent
/// viscosity d tau / d gamma of that flow; what is not sheared moves with the wall that it sticks
/// to. Inertia: 2 pi rho integral of phi^2 r^3 dr with phi the change of the rotation per change of
/// the speed: exact to first order in the acceleration for every law. Decay time: (integral dr /
/// sqrt(nu_tangent))^2 / pi^2 over the sheared layer (exact for a narrow Newtonian gap, 4 % long at
/// delta = 2).
/// @param density  kg/m^3, > 0
[[nodiscard]] GapResponse gap_response(const radial::AnnularGap& gap,
                                       const laws::flow::AnyFlowLaw& law, double density,
                                       const radial::SteadyGapFlow& steady, TurningWall wall);

/// The same for two parallel plates with the uniform shear rate `rate` > 0 between them.
[[nodiscard]] GapResponse plane_gap_response(double width, const laws::flow::AnyFlowLaw& law,
                                             double density, double rate);

/// The torque that inertia adds at a time x = t / decay_time after a sudden change of speed and
/// of acceleration, over the disturbance's own scale; of a plane gap.
/// after_jump: sum of exp(-n^2 x), n >= 1, x > 0. Torque = (6 / pi^2) inertia / decay_time * change
/// of speed * this.
[[nodiscard]] double after_jump(double x);
/// after_kink: sum of (1 - exp(-n^2 x)) / n^2, rising from 0 to pi^2 / 6, x >= 0. Torque =
/// (6 / pi^2) inertia * change of acceleration * this.
[[nodiscard]] double after_kink(double x);

} // namespace searle::solvers
