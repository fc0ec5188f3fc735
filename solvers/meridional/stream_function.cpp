#include "solvers/meridional/stream_function.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace searle::solvers::meridional {

Eigen::VectorXd stream_function(const FlowSpace& space, const Eigen::MatrixX3d& velocity) {
    using Index = Eigen::Index;
    std::vector<int> unknown(static_cast<std::size_t>(space.nodes()), -1);
    int unknowns = 0;
    for (int node = 0; node < space.nodes(); ++node) {
        if (space.boundary(node) == axisymmetric::interior_side) {
            unknown[static_cast<std::size_t>(node)] = unknowns++;
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns);
    for (const FlowSpace::Element& element : space.elements()) {
        const auto locals = static_cast<Index>(element.node.size());
        Eigen::VectorXd u(locals);
        Eigen::VectorXd w(locals);
        for (Index k = 0; k < locals; ++k) {
            const int node = element.node[static_cast<std::size_t>(k)];
            u[k] = velocity(node, static_cast<Index>(Component::radial));
            w[k] = velocity(node, static_cast<Index>(Component::axial));
        }
        const Eigen::VectorXd by_square = (element.weight / element.radius.square()).matrix();
        const Eigen::ArrayXd by_radius = element.weight / element.radius;
        const Eigen::MatrixXd stiffness =
            element.along_r.transpose() * by_square.asDiagonal() * element.along_r +
            element.along_z.transpose() * by_square.asDiagonal() * element.along_z;
        const Eigen::VectorXd up = (by_radius * (space.values() * w).array()).matrix();
        const Eigen::VectorXd out = (by_radius * (space.values() * u).array()).matrix();
        const Eigen::VectorXd moment =
            element.along_r.transpose() * up - element.along_z.transpose() * out;
        for (Index j = 0; j < locals; ++j) {
            const int column =
                unknown[static_cast<std::size_t>(element.node[static_cast<std::size_t>(j)])];
            if (column < 0) {
                continue;
            }
            load[column] += moment[j];
            for (Index i = 0; i < locals; ++i) {
                const int row =
                    unknown[static_cast<std::size_t>(element.node[static_cast<std::size_t>(i)])];
                if (row >= column) {
                    entries.emplace_back(row, column, stiffness(i, j));
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(matrix);
    const Eigen::VectorXd found = factor.solve(load);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(space.nodes());
    for (int node = 0; node < space.nodes(); ++node) {
        if (unknown[static_cast<std::size_t>(node)] >= 0) {
            values[node] = found[unknown[static_cast<std::size_t>(node)]];
        }
    }
    return values;
}

} // namespace searle::solvers::meridional
