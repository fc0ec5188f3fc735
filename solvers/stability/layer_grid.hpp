#pragma once

#include "solvers/stability/eigen_dense.hpp"

namespace searle::solvers::stability {

/// Nodes across a layer, from the inner wall (xi = 0) to its outer end (xi = 1). Graded to the
/// outer end, where a yield surface makes viscosities run to infinity and rates to zero with any
/// power of the distance: 1 - xi = (1 - zeta)^3 with Gauss nodes in zeta.
struct LayerGrid {
    Eigen::VectorXd position;  ///< xi, increasing
    Eigen::VectorXd remaining; ///< 1 - xi, without cancellation
    Eigen::VectorXd weights;   ///< of an integral over xi
    Eigen::MatrixXd to_outer;  ///< values at the nodes -> integrals from each node to xi = 1
};

/// Made once for each number of nodes and kept. Safe to call from several threads.
/// @param nodes  >= 2
[[nodiscard]] const LayerGrid& layer_grid(int nodes);

} // namespace searle::solvers::stability
