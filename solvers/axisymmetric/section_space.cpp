#include "solvers/axisymmetric/section_space.hpp"

#include <cmath>

namespace searle::solvers::axisymmetric {
namespace {

/// Position in an element, and what turns slopes in (x, y) of [-1, 1]^2 into slopes in (r, z).
struct Place {
    double r, z, r_x, z_x, z_y;
};
Place place_in(const SectionElement& e, double x, double y) {
    const double right = 0.5 * (1.0 + x);
    const double bottom = e.bottom_left + (e.bottom_right - e.bottom_left) * right;
    const double top = e.top_left + (e.top_right - e.top_left) * right;
    const double up = 0.5 * (1.0 + y);
    return {.r = e.left + (e.right - e.left) * right,
            .z = bottom + (top - bottom) * up,
            .r_x = 0.5 * (e.right - e.left),
            .z_x = 0.5 * ((1.0 - up) * (e.bottom_right - e.bottom_left) +
                          up * (e.top_right - e.top_left)),
            .z_y = 0.5 * (top - bottom)};
}

} // namespace

std::vector<LocalNode> local_nodes(int degree) {
    std::vector<LocalNode> order{{0, 0}, {degree, 0}, {0, degree}, {degree, degree}};
    for (const int row : {0, degree}) {
        for (int i = 1; i < degree; ++i) {
            order.push_back({i, row});
        }
    }
    for (const int column : {0, degree}) {
        for (int j = 1; j < degree; ++j) {
            order.push_back({column, j});
        }
    }
    for (int j = 1; j < degree; ++j) {
        for (int i = 1; i < degree; ++i) {
            order.push_back({i, j});
        }
    }
    return order;
}

SectionSpace::SectionSpace(const SectionMesh& mesh, Field field, int degree, int points)
    : SectionSpace(mesh, field, degree, gauss_legendre(points)) {}

SectionSpace::SectionSpace(const SectionMesh& mesh, Field field, int degree, const LineRule& rule)
    : degree_(degree) {
    const auto points = static_cast<int>(rule.node.size());
    number_nodes(mesh, field);
    const std::vector<LocalNode> order = local_nodes(degree);
    const auto locals = static_cast<Eigen::Index>(order.size());
    const Eigen::VectorXd nodes = lobatto_nodes(degree);
    const LineBasis plain = lagrange_basis(nodes, rule.node);
    const LineBasis at_axis = axis_basis(nodes, rule.node, axis_power);

    values_.resize(points * points, locals);
    for (int b = 0; b < points; ++b) {
        for (int a = 0; a < points; ++a) {
            for (Eigen::Index k = 0; k < locals; ++k) {
                const LocalNode& local = order[static_cast<std::size_t>(k)];
                values_(b * points + a, k) =
                    plain.value(a, local.column) * plain.value(b, local.row);
            }
        }
    }
    position_.resize(nodes_, 2);
    for (std::size_t index = 0; index < elements_.size(); ++index) {
        const SectionElement& shape = mesh.elements[index];
        Element& element = elements_[index];
        const bool touches_axis = field == Field::stress_function && shape.left == 0.0;
        const LineBasis& across = touches_axis ? at_axis : plain;
        const int count = points * points;
        element.slope.resize(2L * count, locals);
        element.weight.resize(count);
        element.radius.resize(count);
        element.height.resize(count);
        for (int b = 0; b < points; ++b) {
            for (int a = 0; a < points; ++a) {
                const int q = b * points + a;
                const Place at = place_in(shape, rule.node[a], rule.node[b]);
                const double scale = field == Field::rotation ? at.r : 1.0 / (at.r * at.r);
                element.radius[q] = at.r;
                element.height[q] = at.z;
                element.weight[q] = rule.weight[a] * rule.weight[b] * at.r * at.r_x * at.z_y;
                for (Eigen::Index k = 0; k < locals; ++k) {
                    const LocalNode& local = order[static_cast<std::size_t>(k)];
                    const double along_x =
                        across.slope(a, local.column) * plain.value(b, local.row);
                    const double along_y =
                        across.value(a, local.column) * plain.slope(b, local.row);
                    const double along_z = along_y / at.z_y;
                    element.slope(q, k) = scale * (along_x - along_z * at.z_x) / at.r_x;
                    element.slope(count + q, k) = scale * along_z;
                }
            }
        }
        for (std::size_t k = 0; k < order.size(); ++k) {
            const Place at = place_in(shape, nodes[order[k].column], nodes[order[k].row]);
            position_.row(element.node[k]) << at.r, at.z;
        }
    }
}

long SectionSpace::unknowns() const {
    return shared_unknowns_ + static_cast<long>(elements_.size()) * (degree_ - 1) * (degree_ - 1);
}

void SectionSpace::prescribe(const Eigen::VectorXd& values) {
    for (std::size_t node = 0; node < shared_unknown_.size(); ++node) {
        if (shared_unknown_[node] < 0) {
            prescribed_[static_cast<Eigen::Index>(node)] = values[static_cast<Eigen::Index>(node)];
        }
    }
}

void SectionSpace::number_nodes(const SectionMesh& mesh, Field field) {
    const int inside = degree_ - 1;
    const auto vertices = static_cast<int>(mesh.vertex_boundary.size());
    const auto edges = static_cast<int>(mesh.edge_boundary.size());
    shared_nodes_ = vertices + edges * inside;
    nodes_ = shared_nodes_ + static_cast<int>(mesh.elements.size()) * inside * inside;

    std::vector<unsigned> boundary(mesh.vertex_boundary);
    for (const unsigned side : mesh.edge_boundary) {
        boundary.insert(boundary.end(), static_cast<std::size_t>(inside), side);
    }
    const unsigned fixed =
        field == Field::rotation ? rotor_wall | cup_wall : symmetry_axis | inner_surface;
    std::vector<int> stands_for(static_cast<std::size_t>(shared_nodes_));
    shared_unknown_.assign(static_cast<std::size_t>(shared_nodes_), -1);
    prescribed_ = Eigen::VectorXd::Zero(nodes_);
    for (int node = 0; node < shared_nodes_; ++node) {
        const auto at = static_cast<std::size_t>(node);
        stands_for[at] = node;
        if ((boundary[at] & fixed) != 0U) {
            if (field == Field::rotation && (boundary[at] & rotor_wall) != 0U) {
                prescribed_[node] = 1.0;
            }
            continue;
        }
        if (field == Field::stress_function && (boundary[at] & free_surface) != 0U) {
            if (surface_node_ >= 0) {
                stands_for[at] = surface_node_;
                continue;
            }
            surface_node_ = node;
        }
        shared_unknown_[at] = shared_unknowns_++;
    }

    int next_inside = shared_nodes_;
    for (const SectionElement& shape : mesh.elements) {
        Element element;
        for (const int vertex : shape.vertex) {
            element.node.push_back(stands_for[static_cast<std::size_t>(vertex)]);
        }
        for (const int edge : shape.edge) {
            for (int k = 0; k < inside; ++k) {
                const int node = vertices + edge * inside + k;
                element.node.push_back(stands_for[static_cast<std::size_t>(node)]);
            }
        }
        for (int k = 0; k < inside * inside; ++k) {
            element.node.push_back(next_inside++);
        }
        elements_.push_back(std::move(element));
    }
}

} // namespace searle::solvers::axisymmetric
