#include "solvers/stability/legendre_basis.hpp"

#include "solvers/stability/gauss_nodes.hpp"

#include <cmath>

namespace searle::solvers::stability {

LegendreBasis legendre_basis(int modes) {
    // The products of two modes are integrated exactly, with room for the smooth weights.
    const int count = modes + 24;
    const GaussNodes rule = gauss_nodes(count);
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
