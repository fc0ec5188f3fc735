#pragma once

#include "solvers/axisymmetric/energy_minimiser.hpp"

#include <Eigen/Core>

namespace searle::solvers::meridional {

/// Velocity, slopes and rate of deformation at the Gauss points of one element. Suffixes _r and _z
/// are slopes; u radial, w axial, spin the angular velocity.
struct PointFlow {
    Eigen::ArrayXd u, w, spin;
    Eigen::ArrayXd u_r, u_z, w_r, w_z, spin_r, spin_z;
    Eigen::ArrayXd radius;
    Eigen::ArrayXd viscosity; ///< stress over rate
    /// d viscosity / d(rate^2 / 2): how the viscosity answers to a change of the rate.
    Eigen::ArrayXd stiffening;

    /// @param stacked   slopes along r, along z and values of the local functions, one above the
    ///                  other: (3 points, local node)
    /// @param velocity  (local node, component)
    PointFlow(const Eigen::MatrixXd& stacked, const Eigen::MatrixX3d& velocity,
              const Eigen::ArrayXd& radius_of_points, const axisymmetric::EnergyDensity& law);
};

} // namespace searle::solvers::meridional
