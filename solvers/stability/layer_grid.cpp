#include "solvers/stability/layer_grid.hpp"

#include "solvers/stability/gauss_nodes.hpp"

#include <map>
#include <mutex>

namespace searle::solvers::stability {
namespace {

LayerGrid make_grid(int nodes) {
    const GaussNodes rule = gauss_nodes(nodes);
    const Eigen::ArrayXd left = 0.5 * (1.0 - rule.points.array()); // 1 - zeta
    const Eigen::ArrayXd stretch = 3.0 * left.square();            // d xi / d zeta
    LayerGrid grid;
    grid.remaining = left.cube().matrix();
    grid.position = (1.0 - left.cube()).matrix();
    grid.weights = (0.5 * rule.weights.array() * stretch).matrix();
    // In zeta the values are a sum of Legendre polynomials, and the integral of P_l from t to 1 is
    // (P_(l-1) - P_(l+1)) / (2 l + 1).
    const Eigen::MatrixXd legendre = legendre_polynomials(rule.points, nodes);
    Eigen::MatrixXd integrals(nodes, nodes);
    integrals.col(0) = legendre.col(0) - legendre.col(1);
    for (int l = 1; l < nodes; ++l) {
        integrals.col(l) = legendre.col(l - 1) - legendre.col(l + 1);
    }
    grid.to_outer = integrals * legendre.leftCols(nodes).transpose() *
                    (0.25 * rule.weights.array() * stretch).matrix().asDiagonal();
    return grid;
}

} // namespace

const LayerGrid& layer_grid(int nodes) {
    static std::mutex guard;
    static std::map<int, LayerGrid> known;
    const std::lock_guard lock(guard);
    const auto found = known.find(nodes);
    return found != known.end() ? found->second
                                : known.emplace(nodes, make_grid(nodes)).first->second;
}

} // namespace searle::solvers::stability
