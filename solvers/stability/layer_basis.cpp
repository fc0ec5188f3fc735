#include "solvers/stability/layer_basis.hpp"

namespace searle::solvers::stability {
namespace {

/// Column k: polynomial of degree k at the nodes, orthonormal under the weights (all > 0).
Eigen::MatrixXd orthonormal_polynomials(const Eigen::VectorXd& position,
                                        const Eigen::VectorXd& weights, int count) {
    Eigen::MatrixXd polynomials(position.size(), count);
    Eigen::VectorXd next = Eigen::VectorXd::Ones(position.size());
    for (int k = 0; k < count; ++k) {
        // Twice: once leaves what rounding mixed in.
        for (int sweep = 0; sweep < 2 && k > 0; ++sweep) {
            const auto before = polynomials.leftCols(k);
            next -= before * (before.transpose() * weights.cwiseProduct(next));
        }
        next /= std::sqrt(weights.dot(next.cwiseAbs2()));
        polynomials.col(k) = next;
        next = next.cwiseProduct(position);
    }
    return polynomials;
}

} // namespace

LayerBasis layer_basis(const ShearedLayer& layer, int modes) {
    const LayerGrid& grid = *layer.grid;
    const Eigen::ArrayXd square = (2.0 * layer.depth * grid.position.array()).exp();
    const Eigen::VectorXd bending = (square / layer.secant).matrix();
    const Eigen::VectorXd sliding = (1.0 / (square * layer.tangent)).matrix();
    LayerBasis basis;
    // The first two polynomials would not return to zero at the inner end, the first not here.
    basis.clamped_curvature =
        bending.asDiagonal() *
        orthonormal_polynomials(grid.position, grid.weights.cwiseProduct(bending), modes + 2)
            .rightCols(modes);
    basis.clamped_slope = -grid.to_outer * basis.clamped_curvature;
    basis.clamped = -grid.to_outer * basis.clamped_slope;
    basis.pinned_slope =
        sliding.asDiagonal() *
        orthonormal_polynomials(grid.position, grid.weights.cwiseProduct(sliding), modes + 1)
            .rightCols(modes);
    basis.pinned = -grid.to_outer * basis.pinned_slope;
    return basis;
}

} // namespace searle::solvers::stability
