#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"

#include <Eigen/Core>

namespace searle::solvers::axisymmetric {

/// Swirl on the finite elements of a section.
struct SwirlSolution {
    const SectionMesh& mesh;
    double length{};                 ///< m, of the mesh's unit
    int degree{};                    ///< of the elements
    const Eigen::VectorXd& rotation; ///< angular velocity over `speed` at the space's nodes
    double speed{};                  ///< rad/s
    double rate_scale{};             ///< 1/s, a typical rate of shear
    /// The stress that balances momentum, over `stress_scale`; null: stresses are the law's at the
    /// rates of the rotation.
    const Eigen::VectorXd* stress_function = nullptr;
    double stress_scale{}; ///< Pa
    /// Flow in r and z at the nodes of the rotation; null: there is none.
    const Eigen::VectorXd* radial = nullptr;          ///< over |speed| length
    const Eigen::VectorXd* axial = nullptr;           ///< over |speed| length
    const Eigen::VectorXd* stream_function = nullptr; ///< over |speed| length^3
};

/// Velocity, angular velocity, rate, stress, viscosity, the yielded flag and, with secondary flow,
/// the stream function at points inside and on the outline of every element (names in
/// section_fields.hpp). Row, time and speed of the result are left to the caller, as far as
/// `solution` does not say them.
[[nodiscard]] rheometry::fields::SectionFields swirl_fields(const SwirlSolution& solution,
                                                            const laws::flow::AnyFlowLaw& law);

} // namespace searle::solvers::axisymmetric
