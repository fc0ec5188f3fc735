#pragma once

#include <Eigen/Core>

namespace searle::solvers::axisymmetric {

/// Gauss–Legendre rule on [-1, 1] with any number of points; nodes increasing.
struct LineRule {
    Eigen::VectorXd node;
    Eigen::VectorXd weight;
};
[[nodiscard]] LineRule gauss_legendre(int points);

/// The nodes of Gauss–Lobatto–Legendre on [-1, 1], degree + 1 of them, both ends included:
/// Lagrange polynomials on them are well conditioned at any degree.
[[nodiscard]] Eigen::VectorXd lobatto_nodes(int degree);

/// Values and slopes of functions of one coordinate at the points of a rule: (point, function).
struct LineBasis {
    Eigen::MatrixXd value;
    Eigen::MatrixXd slope;
};

/// Lagrange polynomials on `nodes`.
[[nodiscard]] LineBasis lagrange_basis(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points);

/// On an element that touches the axis at -1, r = (1 + x) / 2 of its width: the functions r^power
/// times polynomials of degree one less, with the value 1 at their own node, 0 at the others, and
/// 0 on the axis. Function 0, which would live on the axis, is zero.
[[nodiscard]] LineBasis axis_basis(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points,
                                   int power);

} // namespace searle::solvers::axisymmetric
