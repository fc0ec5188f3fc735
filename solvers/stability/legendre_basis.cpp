#include "solvers/stability/legendre_basis.hpp"

#include <cmath>
#include <numbers>

namespace searle::solvers::stability {
namespace {

/// Row p: P_0 ... P_degree at point p, by the three-term recurrence.
Eigen::MatrixXd legendre_polynomials(const Eigen::VectorXd& points, int degree) {
    Eigen::MatrixXd values(points.size(), degree + 1);
    values.col(0).setOnes();
    values.col(1) = points;
    for (int l = 1; l < degree; ++l) {
        const double order = l;
        values.col(l + 1) =
            ((2.0 * order + 1.0) * points.cwiseProduct(values.col(l)) - order * values.col(l - 1)) /
            (order + 1.0);
    }
    return values;
}

struct GaussRule {
    Eigen::VectorXd points; ///< in -1 ... 1
    Eigen::VectorXd weights;
};

/// Newton on P_count from Tricomi's estimate of its zeros, all at once.
GaussRule gauss_rule(int count) {
    Eigen::VectorXd points(count);
    for (int i = 0; i < count; ++i) {
        points[i] = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    }
    Eigen::VectorXd slopes(count);
    for (int iteration = 0; iteration < 6; ++iteration) {
        const Eigen::MatrixXd values = legendre_polynomials(points, count);
        slopes = count * (values.col(count - 1) - points.cwiseProduct(values.col(count)))
                             .cwiseQuotient((1.0 - points.array().square()).matrix());
        const Eigen::VectorXd step = values.col(count).cwiseQuotient(slopes);
        points -= step;
        if (step.cwiseAbs().maxCoeff() < 1e-15) {
            break;
        }
    }
    GaussRule rule;
    rule.weights = (2.0 / ((1.0 - points.array().square()) * slopes.array().square())).matrix();
    rule.points = std::move(points);
    return rule;
}

} // namespace

LegendreBasis legendre_basis(int modes) {
    // The products of two modes are integrated exactly, with room for the smooth weights.
    const int count = modes + 24;
    const GaussRule rule = gauss_rule(count);
    const Eigen::MatrixXd legendre = legendre_polynomials(rule.points, modes + 3);
    LegendreBasis basis;
    basis.nodes = 0.5 * (rule.points.array() + 1.0);
    basis.weights = 0.5 * rule.weights;
    basis.pinned.resize(count, modes);
    basis.pinned_slope.resize(count, modes);
    basis.clamped.resize(count, modes);
    basis.clamped_curvature.resize(count, modes);
    for (int m = 0; m < modes; ++m) {
        // d/dxi = 2 d/dx on -1 ... 1; the norms are those of the highest derivative.
        const int p = m + 1;
        const double pinned_degree = p;
        const double pinned_norm = std::sqrt(2.0 * pinned_degree + 1.0);
        basis.pinned_slope.col(m) = pinned_norm * legendre.col(p);
        basis.pinned.col(m) = 0.5 * pinned_norm / (2.0 * pinned_degree + 1.0) *
                              (legendre.col(p + 1) - legendre.col(p - 1));
        const int q = m + 2;
        const double clamped_degree = q;
        const double clamped_norm = std::sqrt(2.0 * clamped_degree + 1.0);
        basis.clamped_curvature.col(m) = clamped_norm * legendre.col(q);
        basis.clamped.col(m) =
            0.25 * clamped_norm / (2.0 * clamped_degree + 1.0) *
            ((legendre.col(q + 2) - legendre.col(q)) / (2.0 * clamped_degree + 3.0) -
             (legendre.col(q) - legendre.col(q - 2)) / (2.0 * clamped_degree - 1.0));
    }
    return basis;
}

} // namespace searle::solvers::stability
