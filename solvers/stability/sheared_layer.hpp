#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/stability/layer_grid.hpp"

namespace searle::solvers::stability {

/// The steady flow between a turning bob and a cup at rest as a small disturbance feels it, at the
/// nodes of a layer_grid in ln r: from the bob to the cup or to the yield surface. Where the
/// viscosity is more than 1e8 times that at the bob the fluid counts as rigid, too.
struct ShearedLayer {
    const LayerGrid* grid{}; ///< xi = ln(r / R_bob) / depth
    double depth{};          ///< ln(outer radius of the layer / R_bob)
    double wall_viscosity{}; ///< Pa s, stress over rate at the bob
    double wall_rate{};      ///< 1/s
    double covered_speed{}; ///< speed that the rates at the nodes add up to, over the bob's: near 1
    Eigen::ArrayXd rate;    ///< shear rate over the bob's angular velocity
    Eigen::ArrayXd rotation; ///< angular velocity over the bob's
    Eigen::ArrayXd secant;   ///< stress / rate over that at the bob
    Eigen::ArrayXd tangent;  ///< d stress / d rate over the secant one at the bob
};

/// @param flow   radial::steady_gap_flow of the gap, the law and the speed
/// @param speed  rad/s, > 0
/// @param nodes  of the grid, >= 2
[[nodiscard]] ShearedLayer sheared_layer(const radial::AnnularGap& gap,
                                         const laws::flow::AnyFlowLaw& law,
                                         const radial::SteadyGapFlow& flow, double speed,
                                         int nodes);

} // namespace searle::solvers::stability
