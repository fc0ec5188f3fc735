#pragma once

#include "solvers/meridional/flow_space.hpp"

#include <Eigen/Core>

namespace searle::solvers::meridional {

/// Stokes' stream function psi of the velocity in r and z, at the nodes: u = -psi_z / r,
/// w = psi_r / r, 0 on the whole outline, since nothing flows through it. The one whose velocity is
/// nearest to the given one in the mean square. Over speed x radius^3.
/// @param velocity  FlowState::velocity
[[nodiscard]] Eigen::VectorXd stream_function(const FlowSpace& space,
                                              const Eigen::MatrixX3d& velocity);

} // namespace searle::solvers::meridional
