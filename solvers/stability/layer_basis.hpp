#pragma once

#include "solvers/stability/sheared_layer.hpp"

namespace searle::solvers::stability {

/// Functions for a disturbance of a sheared layer between rigid ends, at the nodes of its grid.
/// Each is built from its highest derivative down, which is a fluidity times a polynomial; the
/// polynomials are orthonormal in that fluidity. So stresses stay finite where the viscosity runs
/// to infinity (at a yield surface the functions vanish as the exact ones do), the conditions at
/// both ends hold exactly, and the leading matrices are unity whatever the viscosities. With one
/// viscosity the polynomials are those of Legendre.
struct LayerBasis {
    /// Column m: function that vanishes at both ends with its slope, the slope, and its second
    /// derivative q(xi) y^2 / secant, y = r / R_bob.
    Eigen::MatrixXd clamped;
    Eigen::MatrixXd clamped_slope;
    Eigen::MatrixXd clamped_curvature;
    /// Column m: function that vanishes at both ends, and its slope q(xi) / (y^2 tangent).
    Eigen::MatrixXd pinned;
    Eigen::MatrixXd pinned_slope;
};

/// @param modes  functions of each kind, >= 1; not more than a third of the layer's nodes
[[nodiscard]] LayerBasis layer_basis(const ShearedLayer& layer, int modes);

} // namespace searle::solvers::stability
