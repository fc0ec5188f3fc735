#pragma once

#include "solvers/axisymmetric/nodal_basis.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"

#include <Eigen/Core>
#include <vector>

namespace searle::solvers::axisymmetric {

/// The two unknown fields that describe swirl (docs/axisymmetric.md).
enum class Field {
    /// Angular velocity over that of the rotor: 1 on the rotor, 0 on the cup. |g| is the rate of
    /// shear over the rotor's speed, g = r grad w.
    rotation,
    /// Stress function psi, r^2 stress = curl psi: 0 on the axis (on a double gap's inner surface),
    /// one unknown value on the free surface, which is the torque over 2 pi. |g| is the stress, g =
    /// grad psi / r^2. Momentum is
    /// balanced exactly, whatever psi.
    stress_function
};

/// Power of r that the stress function starts with at the axis. A fluid that is sheared there has
/// psi ~ r^(3 + n), a yield-stress fluid r^3, and r^3 times polynomials holds what follows.
constexpr int axis_power = 3;

struct LocalNode {
    int column; ///< 0 ... degree, r grows
    int row;    ///< 0 ... degree, z grows
};
/// The nodes of an element in the order of SectionSpace::Element::node: corners, edges (bottom,
/// top, left, right), inside.
[[nodiscard]] std::vector<LocalNode> local_nodes(int degree);

/// Continuous finite elements of one degree on a section, with the gradient g that the energy is a
/// function of, at the points of a Gauss rule in every element. Lengths in bob radii.
class SectionSpace {
public:
    /// @param degree  of the polynomials in each direction, >= 1
    /// @param points  of the Gauss rule in each direction
    SectionSpace(const SectionMesh& mesh, Field field, int degree, int points);
    /// With the points of any rule in place of Gauss's, to look at a field there.
    SectionSpace(const SectionMesh& mesh, Field field, int degree, const LineRule& rule);

    struct Element {
        std::vector<int> node; ///< global node of each local node, those of the edges first
        Eigen::MatrixXd slope; ///< g = slope * nodal values: rows of g_r, then rows of g_z
        Eigen::ArrayXd weight; ///< r dr dz of each point
        Eigen::ArrayXd radius; ///< of each point
        Eigen::ArrayXd height; ///< z of each point
    };
    [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
    [[nodiscard]] int degree() const { return degree_; }
    /// Nodes on the outline of an element; the others, (degree - 1)^2, are its own.
    [[nodiscard]] int outline_nodes() const { return 4 * degree_; }
    [[nodiscard]] int nodes() const { return nodes_; }
    /// Nodes on the outlines of elements: 0 ... shared_nodes() - 1.
    [[nodiscard]] int shared_nodes() const { return shared_nodes_; }
    /// Number among the shared unknowns, or -1 where the value is prescribed.
    [[nodiscard]] const std::vector<int>& shared_unknown() const { return shared_unknown_; }
    [[nodiscard]] int shared_unknowns() const { return shared_unknowns_; }
    [[nodiscard]] long unknowns() const;
    /// Prescribed values at their nodes, 0 elsewhere.
    [[nodiscard]] const Eigen::VectorXd& prescribed() const { return prescribed_; }
    /// The node that stands for the whole free surface; stress function only.
    [[nodiscard]] int surface_node() const { return surface_node_; }
    /// Positions of the nodes, for prescribing and comparing fields: (r, z) per node.
    [[nodiscard]] const Eigen::MatrixX2d& position() const { return position_; }
    /// Values of the local functions at the Gauss points of any element away from the axis:
    /// (point, local node).
    [[nodiscard]] const Eigen::MatrixXd& values() const { return values_; }
    /// Prescribes other values; used by tests with manufactured solutions.
    void prescribe(const Eigen::VectorXd& values);

private:
    void number_nodes(const SectionMesh& mesh, Field field);

    int degree_;
    int nodes_{};
    int shared_nodes_{};
    int shared_unknowns_{};
    int surface_node_ = -1;
    std::vector<Element> elements_;
    std::vector<int> shared_unknown_;
    Eigen::VectorXd prescribed_;
    Eigen::MatrixX2d position_;
    Eigen::MatrixXd values_;
};

} // namespace searle::solvers::axisymmetric
