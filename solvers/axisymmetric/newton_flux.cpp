#include "solvers/axisymmetric/newton_flux.hpp"

#include <algorithm>
#include <cstddef>

namespace searle::solvers::axisymmetric {

using Index = Eigen::Index;

Eigen::MatrixXd gradients(const SectionSpace& space, const Eigen::VectorXd& values) {
    const auto& elements = space.elements();
    Eigen::MatrixXd g(elements.front().slope.rows(), static_cast<Index>(elements.size()));
    Eigen::VectorXd local(elements.front().slope.cols());
    for (std::size_t e = 0; e < elements.size(); ++e) {
        for (Index k = 0; k < local.size(); ++k) {
            local[k] = values[elements[e].node[static_cast<std::size_t>(k)]];
        }
        g.col(static_cast<Index>(e)).noalias() = elements[e].slope * local;
    }
    return g;
}

Eigen::MatrixXd next_flux(const EnergyDensity& density, const Eigen::MatrixXd& g,
                          const Eigen::MatrixXd& change, const Eigen::MatrixXd& flux,
                          const Eigen::MatrixXd& g_next) {
    constexpr double inside = 0.999;
    const Index points = g.rows() / 2;
    Eigen::MatrixXd next(g.rows(), g.cols());
    Eigen::ArrayXd secant(points);
    Eigen::ArrayXd tangent(points);
    for (Index e = 0; e < g.cols(); ++e) {
        const Eigen::ArrayXd r = g.col(e).head(points).array();
        const Eigen::ArrayXd z = g.col(e).tail(points).array();
        const Eigen::ArrayXd dr = change.col(e).head(points).array();
        const Eigen::ArrayXd dz = change.col(e).tail(points).array();
        const Eigen::ArrayXd square = r.square() + z.square();
        density.slopes(square.sqrt(), secant, tangent);
        const Eigen::ArrayXd bend =
            (square > 0.0).select((tangent - secant) / (secant * square) * (r * dr + z * dz), 0.0);
        const Eigen::ArrayXd flux_r = secant * (r + dr) + bend * flux.col(e).head(points).array();
        const Eigen::ArrayXd flux_z = secant * (z + dz) + bend * flux.col(e).tail(points).array();

        const Eigen::ArrayXd next_r = g_next.col(e).head(points).array();
        const Eigen::ArrayXd next_z = g_next.col(e).tail(points).array();
        const Eigen::ArrayXd size = (next_r.square() + next_z.square()).sqrt();
        density.slopes(size, secant, tangent);
        const Eigen::ArrayXd length = (flux_r.square() + flux_z.square()).sqrt();
        for (Index q = 0; q < points; ++q) {
            const bool softening = tangent[q] < secant[q];
            const double most =
                softening ? inside * secant[q] * secant[q] * size[q] / (secant[q] - tangent[q])
                          : 0.0;
            const double share = length[q] > most ? most / length[q] : 1.0;
            next(q, e) = softening ? share * flux_r[q] : secant[q] * next_r[q];
            next(points + q, e) = softening ? share * flux_z[q] : secant[q] * next_z[q];
        }
    }
    return next;
}

} // namespace searle::solvers::axisymmetric
