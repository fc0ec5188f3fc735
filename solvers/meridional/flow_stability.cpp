#include "solvers/meridional/flow_stability.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstdint>
#include <limits>

namespace searle::solvers::meridional {
namespace {

/// Real, to the right of all eigenvalues, and near those that decay slowly or turn with a part of
/// the rotor's speed.
constexpr double shift = 0.3;
/// An eigenvalue counts when its residual is below this.
constexpr double believed = 1e-4;

/// A start that has a part in every disturbance; the same in every run.
Eigen::MatrixX3d arbitrary_velocity(const FlowSpace& space) {
    Eigen::MatrixX3d velocity(space.nodes(), 3);
    std::uint64_t state = 1;
    for (int node = 0; node < space.nodes(); ++node) {
        for (Eigen::Index c = 0; c < 3; ++c) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            velocity(node, c) = static_cast<double>(state >> 40U) * 0x1p-23 - 1.0;
        }
    }
    return velocity;
}

} // namespace

LeadingDisturbance leading_disturbance(FlowLevel& level, const FlowMaterial& material,
                                       int vectors) {
    LeadingDisturbance leading{.rate = {-std::numeric_limits<double>::infinity(), 0.0},
                               .residual = 1.0};
    FlowSystem& system = level.system();
    if (!system.factorise(level.state(), material, shift)) {
        return leading;
    }
    const FlowSpace& space = level.space();
    FlowResidual load{.momentum = {},
                      .continuity = Eigen::MatrixXd::Zero(level.state().pressure.rows(),
                                                          level.state().pressure.cols())};
    const auto apply = [&](const Eigen::MatrixX3d& velocity) {
        load.momentum = -system.inertia(velocity, material.reynolds);
        return Eigen::MatrixX3d(system.newton_change(load).velocity);
    };
    const Eigen::Index size = 3L * space.nodes();
    Eigen::MatrixXd basis(size, vectors + 1);
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(vectors + 1, vectors);
    const Eigen::MatrixX3d start = apply(arbitrary_velocity(space));
    basis.col(0) = start.reshaped() / start.norm();
    int used = vectors;
    for (int k = 0; k < vectors; ++k) {
        Eigen::VectorXd next = apply(basis.col(k).reshaped(space.nodes(), 3)).reshaped();
        // Twice is enough for orthogonality to rounding.
        for (int pass = 0; pass < 2; ++pass) {
            const Eigen::VectorXd along = basis.leftCols(k + 1).transpose() * next;
            next.noalias() -= basis.leftCols(k + 1) * along;
            hessenberg.col(k).head(k + 1) += along;
        }
        const double length = next.norm();
        hessenberg(k + 1, k) = length;
        if (length < 1e-13) {
            used = k + 1;
            break;
        }
        basis.col(k + 1) = next / length;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(hessenberg.topLeftCorner(used, used));
    const double beyond = hessenberg(used, used - 1);
    for (int k = 0; k < used; ++k) {
        const std::complex<double> inverse = solver.eigenvalues()[k];
        const Eigen::VectorXcd vector = solver.eigenvectors().col(k);
        const double residual =
            beyond * std::abs(vector[used - 1]) / vector.norm() / std::abs(inverse);
        const std::complex<double> rate = shift - 1.0 / inverse;
        if (residual < believed && rate.real() > leading.rate.real()) {
            leading = {{rate.real(), std::abs(rate.imag())}, residual};
        }
    }
    return leading;
}

} // namespace searle::solvers::meridional
