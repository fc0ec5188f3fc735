#pragma once

#include "solvers/stability/eigen_dense.hpp"

namespace searle::solvers::stability {

/// Row p: P_0 ... P_degree at point p, in -1 ... 1, by the three-term recurrence.
/// @param degree  >= 1
[[nodiscard]] Eigen::MatrixXd legendre_polynomials(const Eigen::VectorXd& points, int degree);

/// Gauss-Legendre rule on -1 ... 1, for any number of points.
struct GaussNodes {
    Eigen::VectorXd points; ///< increasing
    Eigen::VectorXd weights;
};
[[nodiscard]] GaussNodes gauss_nodes(int count);

} // namespace searle::solvers::stability
