#pragma once

#include "solvers/stability/eigen_dense.hpp"

namespace searle::solvers::stability {

/// Polynomials on 0 <= xi <= 1 that fulfil the boundary conditions of a perturbation between two
/// rigid walls, tabulated at the nodes of a Gauss rule. Each is built from the derivative down
/// (its highest derivative is a normalised Legendre polynomial), which keeps the matrices of second
/// and fourth order operators well conditioned at every resolution.
struct LegendreBasis {
    Eigen::VectorXd nodes;   ///< xi, inside 0 ... 1
    Eigen::VectorXd weights; ///< sum 1
    /// Column m: function of mode m that vanishes at both walls, and its first derivative.
    Eigen::MatrixXd pinned;
    Eigen::MatrixXd pinned_slope;
    /// Column m: function of mode m that vanishes at both walls with its slope, and its second
    /// derivative.
    Eigen::MatrixXd clamped;
    Eigen::MatrixXd clamped_curvature;
};

/// @param modes  number of polynomials of each kind, >= 1
[[nodiscard]] LegendreBasis legendre_basis(int modes);

} // namespace searle::solvers::stability
