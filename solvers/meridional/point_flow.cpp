#include "solvers/meridional/point_flow.hpp"

namespace searle::solvers::meridional {

PointFlow::PointFlow(const Eigen::MatrixXd& stacked, const Eigen::MatrixX3d& velocity,
                     const Eigen::ArrayXd& radius_of_points, const axisymmetric::EnergyDensity& law)
    : radius(radius_of_points) {
    const Eigen::Index points = radius.size();
    const Eigen::MatrixX3d all = stacked * velocity;
    const auto part = [&](Eigen::Index slot, Eigen::Index component) {
        return all.col(component).segment(slot * points, points).array();
    };
    u_r = part(0, 0);
    u_z = part(1, 0);
    u = part(2, 0);
    w_r = part(0, 1);
    w_z = part(1, 1);
    w = part(2, 1);
    spin_r = part(0, 2);
    spin_z = part(1, 2);
    spin = part(2, 2);
    const Eigen::ArrayXd square = 2.0 * (u_r.square() + (u / radius).square() + w_z.square()) +
                                  (u_z + w_r).square() +
                                  radius.square() * (spin_r.square() + spin_z.square());
    viscosity.resize(points);
    Eigen::ArrayXd tangent(points);
    law.slopes(square.sqrt(), viscosity, tangent);
    stiffening = (square > 0.0).select((tangent - viscosity) / square, 0.0);
}

} // namespace searle::solvers::meridional
