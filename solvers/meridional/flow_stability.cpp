#include "solvers/meridional/flow_stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace searle::solvers::meridional {
namespace {

/// Real, to the right of all eigenvalues, and near those that decay slowly or turn with a part of
/// the rotor's speed.
constexpr double shift = 0.3;
/// An eigenvalue counts when its residual is below this.
constexpr double believed = 1e-4;
/// The leading one is looked for after so many vectors, and believed when eight more brought no
/// other and none on its right begins to show: what oscillates fast is far from the shift and
/// comes last.
constexpr int first_look = 24;
constexpr int vectors_between_looks = 8;
constexpr double shows = 0.1; ///< residual of one that begins to
/// A vector that keeps less than this share of its length is made orthogonal once more; twice is
/// enough (Daniel, Gragg, Kaufman and Stewart 1976, Math. Comput. 30, 772).
constexpr double enough_left = 0.7;

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

constexpr LeadingDisturbance nothing_found{.rate = {-std::numeric_limits<double>::infinity(), 0.0},
                                           .residual = 1.0};

struct Look {
    LeadingDisturbance leading = nothing_found;
    bool is_contested{}; ///< one on its right begins to show
};

/// @param hessenberg  of Arnoldi's method, (used + 1, used) or larger
Look look_at(const Eigen::MatrixXd& hessenberg, int used) {
    Look look;
    LeadingDisturbance& leading = look.leading;
    double rightmost = nothing_found.rate.real();
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
        if (residual < shows) {
            rightmost = std::max(rightmost, rate.real());
        }
    }
    look.is_contested = rightmost > leading.rate.real();
    return look;
}

} // namespace

LeadingDisturbance leading_disturbance(FlowLevel& level, const FlowMaterial& material,
                                       const ProgressSink& progress, int vectors) {
    FlowSystem& system = level.system();
    if (!system.factorise(level.state(), material, shift)) {
        return nothing_found;
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
    LeadingDisturbance leading = nothing_found;
    for (int k = 0; k < vectors; ++k) {
        if (progress) {
            progress(static_cast<double>(k) / vectors, "stability of the secondary flow");
        }
        Eigen::VectorXd next = apply(basis.col(k).reshaped(space.nodes(), 3)).reshaped();
        double length = next.norm();
        for (double before = std::numeric_limits<double>::infinity();
             length < enough_left * before;) {
            const Eigen::VectorXd along = basis.leftCols(k + 1).transpose() * next;
            next.noalias() -= basis.leftCols(k + 1) * along;
            hessenberg.col(k).head(k + 1) += along;
            before = std::exchange(length, next.norm());
        }
        hessenberg(k + 1, k) = length;
        const int used = k + 1;
        const bool is_last = used == vectors || length < 1e-13;
        if (is_last || (used >= first_look && (used - first_look) % vectors_between_looks == 0)) {
            const Look found = look_at(hessenberg, used);
            const bool same = std::abs(found.leading.rate - leading.rate) <= believed;
            leading = found.leading;
            if (is_last || (same && !found.is_contested)) {
                break;
            }
        }
        basis.col(k + 1) = next / length;
    }
    return leading;
}

} // namespace searle::solvers::meridional
