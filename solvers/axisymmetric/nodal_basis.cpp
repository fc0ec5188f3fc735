#include "solvers/axisymmetric/nodal_basis.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::axisymmetric {
namespace {

/// P_n(x) and P_(n-1)(x).
std::pair<double, double> legendre(int degree, double x) {
    double present = 1.0;
    double previous = 0.0;
    for (int k = 0; k < degree; ++k) {
        const double next = ((2.0 * k + 1.0) * x * present - k * previous) / (k + 1.0);
        previous = std::exchange(present, next);
    }
    return {present, previous};
}

constexpr int newton_steps = 12;

} // namespace

LineRule gauss_legendre(int points) {
    LineRule rule{Eigen::VectorXd(points), Eigen::VectorXd(points)};
    for (int k = 0; k < points; ++k) {
        double x = -std::cos(std::numbers::pi * (k + 0.75) / (points + 0.5));
        double slope = 0.0;
        for (int step = 0; step < newton_steps; ++step) {
            const auto [value, previous] = legendre(points, x);
            slope = points * (previous - x * value) / (1.0 - x * x);
            x -= value / slope;
        }
        rule.node[k] = x;
        rule.weight[k] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

Eigen::VectorXd lobatto_nodes(int degree) {
    Eigen::VectorXd nodes(degree + 1);
    nodes[0] = -1.0;
    nodes[degree] = 1.0;
    for (int k = 1; k < degree; ++k) {
        double x = -std::cos(std::numbers::pi * k / degree);
        for (int step = 0; step < newton_steps; ++step) {
            const auto [value, previous] = legendre(degree, x);
            // (1 - x^2) P'_n = n (P_(n-1) - x P_n), whose slope is -n (n + 1) P_n.
            x += degree * (previous - x * value) / (degree * (degree + 1.0) * value);
        }
        nodes[k] = x;
    }
    return nodes;
}

LineBasis lagrange_basis(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points) {
    const Eigen::Index count = nodes.size();
    LineBasis basis{Eigen::MatrixXd::Zero(points.size(), count),
                    Eigen::MatrixXd::Zero(points.size(), count)};
    for (Eigen::Index q = 0; q < points.size(); ++q) {
        for (Eigen::Index i = 0; i < count; ++i) {
            double value = 1.0;
            double slope = 0.0;
            for (Eigen::Index j = 0; j < count; ++j) {
                if (j == i) {
                    continue;
                }
                const double factor = (points[q] - nodes[j]) / (nodes[i] - nodes[j]);
                slope = slope * factor + value / (nodes[i] - nodes[j]);
                value *= factor;
            }
            basis.value(q, i) = value;
            basis.slope(q, i) = slope;
        }
    }
    return basis;
}

LineBasis axis_basis(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points, int power) {
    const Eigen::Index count = nodes.size();
    const LineBasis polynomial = lagrange_basis(nodes.tail(count - 1), points);
    LineBasis basis{Eigen::MatrixXd::Zero(points.size(), count),
                    Eigen::MatrixXd::Zero(points.size(), count)};
    for (Eigen::Index q = 0; q < points.size(); ++q) {
        for (Eigen::Index i = 1; i < count; ++i) {
            const double ratio = (1.0 + points[q]) / (1.0 + nodes[i]);
            const double raised = std::pow(ratio, power);
            basis.value(q, i) = raised * polynomial.value(q, i - 1);
            basis.slope(q, i) = raised * polynomial.slope(q, i - 1) +
                                power * raised / (1.0 + points[q]) * polynomial.value(q, i - 1);
        }
    }
    return basis;
}

} // namespace searle::solvers::axisymmetric
