#include "solvers/stability/gauss_nodes.hpp"

#include <cmath>
#include <numbers>

namespace searle::solvers::stability {

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

GaussNodes gauss_nodes(int count) {
    // Newton on P_count from Tricomi's estimate of its zeros, all at once.
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
    GaussNodes rule;
    rule.weights = (2.0 / ((1.0 - points.array().square()) * slopes.array().square())).matrix();
    rule.points = std::move(points);
    return rule;
}

} // namespace searle::solvers::stability
