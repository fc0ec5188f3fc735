#include "solvers/axisymmetric/field_transfer.hpp"

#include "solvers/axisymmetric/nodal_basis.hpp"

#include <algorithm>
#include <map>

namespace searle::solvers::axisymmetric {
namespace {

using Key = std::array<std::size_t, 4>;

/// The nodes on [-1, 1] of an interval of the fine lines, seen from the coarse interval around it.
struct Seen {
    std::size_t interval;
    Eigen::VectorXd node;
};
Seen seen_from(const std::vector<double>& coarse, double from, double to,
               const Eigen::VectorXd& nodes) {
    const double middle = 0.5 * (from + to);
    const auto after = std::upper_bound(coarse.begin(), coarse.end(), middle);
    const auto interval = static_cast<std::size_t>(after - coarse.begin() - 1);
    const double low = coarse[interval];
    const double high = coarse[interval + 1];
    Eigen::VectorXd node = (from + 0.5 * (to - from) * (nodes.array() + 1.0)).matrix();
    node = (2.0 * (node.array() - low) / (high - low) - 1.0).matrix();
    return {interval, std::move(node)};
}

} // namespace

Eigen::VectorXd transferred(const DividedSection& coarse, const Eigen::VectorXd& values,
                            Field field, const DividedSection& fine) {
    std::map<Key, std::size_t> element_at;
    for (std::size_t e = 0; e < coarse.mesh.elements.size(); ++e) {
        const SectionElement& shape = coarse.mesh.elements[e];
        element_at[{shape.family[0], shape.interval[0], shape.family[1], shape.interval[1]}] = e;
    }
    const Eigen::VectorXd from_nodes = lobatto_nodes(coarse.space.degree());
    const Eigen::VectorXd to_nodes = lobatto_nodes(fine.space.degree());
    const std::vector<LocalNode> from_order = local_nodes(coarse.space.degree());
    const std::vector<LocalNode> to_order = local_nodes(fine.space.degree());

    Eigen::VectorXd result = fine.space.prescribed();
    for (std::size_t e = 0; e < fine.mesh.elements.size(); ++e) {
        const SectionElement& shape = fine.mesh.elements[e];
        const auto look = [&](std::size_t direction) {
            const std::size_t family = shape.family[direction];
            const std::vector<double>& lines = fine.lines[family];
            return seen_from(coarse.lines[family], lines[shape.interval[direction]],
                             lines[shape.interval[direction] + 1], to_nodes);
        };
        const Seen across = look(0);
        const Seen along = look(1);
        const std::size_t parent =
            element_at.at({shape.family[0], across.interval, shape.family[1], along.interval});
        const bool at_axis =
            field == Field::stress_function && coarse.mesh.elements[parent].left == 0.0;
        const LineBasis basis_across = at_axis ? axis_basis(from_nodes, across.node, axis_power)
                                               : lagrange_basis(from_nodes, across.node);
        const LineBasis basis_along = lagrange_basis(from_nodes, along.node);
        Eigen::MatrixXd table(from_nodes.size(), from_nodes.size());
        const std::vector<int>& from_node = coarse.space.elements()[parent].node;
        for (std::size_t k = 0; k < from_order.size(); ++k) {
            table(from_order[k].column, from_order[k].row) = values[from_node[k]];
        }
        const Eigen::MatrixXd found = basis_across.value * table * basis_along.value.transpose();
        const std::vector<int>& to_node = fine.space.elements()[e].node;
        for (std::size_t k = 0; k < to_order.size(); ++k) {
            const bool is_free =
                to_node[k] >= fine.space.shared_nodes() ||
                fine.space.shared_unknown()[static_cast<std::size_t>(to_node[k])] >= 0;
            if (is_free) {
                result[to_node[k]] = found(to_order[k].column, to_order[k].row);
            }
        }
    }
    return result;
}

} // namespace searle::solvers::axisymmetric
