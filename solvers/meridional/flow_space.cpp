#include "solvers/meridional/flow_space.hpp"

#include "solvers/axisymmetric/nodal_basis.hpp"

namespace searle::solvers::meridional {
namespace {

using axisymmetric::SectionMesh;

/// P_0 ... P_degree at each point.
Eigen::MatrixXd legendre_values(int degree, const Eigen::VectorXd& points) {
    Eigen::MatrixXd values(points.size(), degree + 1);
    values.col(0).setOnes();
    for (int n = 1; n <= degree; ++n) {
        values.col(n) = (2.0 * n - 1.0) / n * points.array() * values.col(n - 1).array();
        if (n > 1) {
            values.col(n) -= (n - 1.0) / n * values.col(n - 2);
        }
    }
    return values;
}

std::vector<unsigned> boundary_of_nodes(const SectionMesh& mesh, int degree, int nodes) {
    std::vector<unsigned> boundary(mesh.vertex_boundary);
    for (const unsigned side : mesh.edge_boundary) {
        boundary.insert(boundary.end(), static_cast<std::size_t>(degree - 1), side);
    }
    boundary.resize(static_cast<std::size_t>(nodes), axisymmetric::interior_side);
    return boundary;
}

} // namespace

FlowSpace::FlowSpace(const SectionMesh& mesh, int degree, int points)
    : geometry_(mesh, axisymmetric::Field::rotation, degree, points),
      boundary_(boundary_of_nodes(mesh, degree, geometry_.nodes())) {
    const Eigen::Index count = static_cast<Eigen::Index>(points) * points;
    for (const auto& swirl : geometry_.elements()) {
        Element element{.node = swirl.node,
                        .along_r = swirl.slope.topRows(count),
                        .along_z = swirl.slope.bottomRows(count),
                        .weight = swirl.weight,
                        .radius = swirl.radius};
        // The swirl's slopes carry a factor r.
        const Eigen::VectorXd inverse = swirl.radius.inverse().matrix();
        element.along_r = inverse.asDiagonal() * element.along_r;
        element.along_z = inverse.asDiagonal() * element.along_z;
        elements_.push_back(std::move(element));
    }

    const int top = degree - 1;
    const Eigen::MatrixXd legendre =
        legendre_values(top, axisymmetric::gauss_legendre(points).node);
    pressure_values_.resize(count, static_cast<Eigen::Index>(degree) * (degree + 1) / 2);
    Eigen::Index function = 0;
    for (int total = 0; total <= top; ++total) {
        for (int in_x = 0; in_x <= total; ++in_x, ++function) {
            for (int b = 0; b < points; ++b) {
                for (int a = 0; a < points; ++a) {
                    pressure_values_(b * points + a, function) =
                        legendre(a, in_x) * legendre(b, total - in_x);
                }
            }
        }
    }

    for (std::size_t c = 0; c < components; ++c) {
        outline_unknown_[c].assign(static_cast<std::size_t>(nodes()), -1);
    }
    for (int node = 0; node < geometry_.shared_nodes(); ++node) {
        for (std::size_t c = 0; c < components; ++c) {
            if (!is_prescribed(static_cast<Component>(c), node)) {
                outline_unknown_[c][static_cast<std::size_t>(node)] = outline_unknowns_++;
            }
        }
    }
}

bool FlowSpace::is_prescribed(Component component, int node) const {
    using enum axisymmetric::Boundary;
    const unsigned walls = rotor_wall | cup_wall;
    switch (component) {
    case Component::radial:
        return (boundary(node) & (walls | symmetry_axis)) != 0U;
    case Component::axial:
        return (boundary(node) & (walls | free_surface)) != 0U;
    case Component::rotation:
        break;
    }
    return (boundary(node) & walls) != 0U;
}

long FlowSpace::unknowns() const {
    const long inside = static_cast<long>(degree() - 1) * (degree() - 1) * long{components};
    return outline_unknowns_ +
           static_cast<long>(elements_.size()) * (inside + pressure_values_.cols());
}

FlowState rest(const FlowSpace& space) {
    return {.velocity = Eigen::MatrixX3d::Zero(space.nodes(), 3),
            .pressure = Eigen::MatrixXd::Zero(space.pressure_values().cols(),
                                              static_cast<Eigen::Index>(space.elements().size()))};
}

} // namespace searle::solvers::meridional
