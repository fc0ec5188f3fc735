#pragma once

#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/axisymmetric/section_space.hpp"

#include <array>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

namespace searle::solvers::meridional {

/// The unknown fields on the nodes, in this order everywhere: radial and axial velocity over
/// (rotor speed x bob radius), angular velocity over the rotor's speed.
enum class Component : std::size_t { radial, axial, rotation };
constexpr std::size_t components = 3;

/// Velocity and pressure on a section: continuous polynomials of degree k for the three components
/// of the velocity, discontinuous ones of total degree k - 1 for the pressure (Q_k / P_(k-1), a
/// pair that is stable for k >= 2). The flow is the same at every angle. Lengths in bob radii.
class FlowSpace {
public:
    /// @param degree  k >= 2
    /// @param points  of the Gauss rule in each direction, >= k + 1
    FlowSpace(const axisymmetric::SectionMesh& mesh, int degree, int points);

    struct Element {
        std::vector<int> node;   ///< global node of each local node, those of the edges first
        Eigen::MatrixXd along_r; ///< slopes of the local functions: (point, local node)
        Eigen::MatrixXd along_z;
        Eigen::ArrayXd weight; ///< r dr dz of each point
        Eigen::ArrayXd radius; ///< of each point
    };
    [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
    /// Values of the local functions at the Gauss points: (point, local node).
    [[nodiscard]] const Eigen::MatrixXd& values() const { return geometry_.values(); }
    /// Values of the local pressure functions, the constant 1 first: (point, function).
    [[nodiscard]] const Eigen::MatrixXd& pressure_values() const { return pressure_values_; }
    [[nodiscard]] int degree() const { return geometry_.degree(); }
    [[nodiscard]] int nodes() const { return geometry_.nodes(); }
    [[nodiscard]] int outline_nodes() const { return geometry_.outline_nodes(); }
    /// Boundary bits of a node (axisymmetric::Boundary).
    [[nodiscard]] unsigned boundary(int node) const {
        return boundary_[static_cast<std::size_t>(node)];
    }
    /// Whether a wall, the free surface or the axis sets this component at this node.
    [[nodiscard]] bool is_prescribed(Component component, int node) const;
    /// Number of a component at a node among the unknowns on outlines of elements, or -1.
    [[nodiscard]] int outline_unknown(Component component, int node) const {
        return outline_unknown_[static_cast<std::size_t>(component)]
                               [static_cast<std::size_t>(node)];
    }
    [[nodiscard]] int outline_unknowns() const { return outline_unknowns_; }
    /// All unknowns, those inside elements and the pressure included.
    [[nodiscard]] long unknowns() const;
    /// The nodes as a space for the swirl alone; same nodes, same numbers.
    [[nodiscard]] const axisymmetric::SectionSpace& swirl_space() const { return geometry_; }

private:
    axisymmetric::SectionSpace geometry_;
    std::vector<Element> elements_;
    std::vector<unsigned> boundary_;
    std::array<std::vector<int>, components> outline_unknown_;
    int outline_unknowns_{};
    Eigen::MatrixXd pressure_values_;
};

/// A flow on a space.
struct FlowState {
    Eigen::MatrixX3d velocity; ///< (node, component), prescribed values in place
    Eigen::MatrixXd pressure;  ///< (function, element); over stress scale
};

/// All at rest.
[[nodiscard]] FlowState rest(const FlowSpace& space);

} // namespace searle::solvers::meridional
