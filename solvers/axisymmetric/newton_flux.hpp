#pragma once

#include "solvers/axisymmetric/energy_minimiser.hpp"
#include "solvers/axisymmetric/section_space.hpp"

#include <Eigen/Core>

namespace searle::solvers::axisymmetric {

/// g at all points: rows of g_r above rows of g_z, one column an element.
[[nodiscard]] Eigen::MatrixXd gradients(const SectionSpace& space, const Eigen::VectorXd& values);

/// The flux F'(|g|) g/|g| that a Newton step leads to, linearised about the flux and not about g:
/// Chan, Golub & Mulet 1999, SIAM J. Sci. Comput. 20, 1964. Where |g| is small the flux of a
/// yield-stress fluid turns fast with g but is smooth in space, so it is the better unknown. It is
/// kept where the second derivative stays positive. Where F'' >= F'/|g| it is Newton's own.
[[nodiscard]] Eigen::MatrixXd next_flux(const EnergyDensity& density, const Eigen::MatrixXd& g,
                                        const Eigen::MatrixXd& change, const Eigen::MatrixXd& flux,
                                        const Eigen::MatrixXd& g_next);

} // namespace searle::solvers::axisymmetric
