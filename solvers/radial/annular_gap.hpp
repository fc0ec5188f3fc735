#pragma once

#include "laws/flow/flow_law.hpp"

namespace searle::solvers::radial {

/// An endless annulus, inner radius < outer radius, m.
struct AnnularGap {
    double inner_radius{};
    double outer_radius{};

    [[nodiscard]] constexpr double width() const { return outer_radius - inner_radius; }
    /// delta^2 - 1 without cancellation for a narrow gap.
    [[nodiscard]] constexpr double ratio_squared_minus_one() const {
        return (outer_radius - inner_radius) * (outer_radius + inner_radius) /
               (inner_radius * inner_radius);
    }
};

/// Steady creeping flow between two cylinders that turn at speeds differing by omega.
struct SteadyGapFlow {
    double torque_per_length{}; ///< N, magnitude
    double inner_wall_stress{}; ///< Pa
    double inner_wall_rate{};   ///< 1/s
    double outer_wall_rate{};   ///< 1/s; 0 when the gap is partly sheared
    double yield_radius{};      ///< m; the outer radius when all of the gap is sheared
    bool partly_sheared{};
    double relative_error{}; ///< bound on the relative error of the torque
};

/// Solves omega = 1/2 integral from max(yield, tau/delta^2) to tau of rate(q)/q dq for the stress
/// tau at the inner wall (docs/radial.md, eq. 2). No mesh, no regularisation: quadrature
/// in ln(rate), safeguarded Newton. Relative error of the torque <= 1e-10 for radius ratios
/// from 1.001 on; `relative_error` says what it is, also in narrower gaps.
/// @param omega  difference of the two speeds, rad/s, > 0
[[nodiscard]] SteadyGapFlow steady_gap_flow(const AnnularGap& gap,
                                            const laws::flow::AnyFlowLaw& law, double omega);

} // namespace searle::solvers::radial
