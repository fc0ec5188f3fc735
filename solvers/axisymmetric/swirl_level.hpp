#pragma once

#include "solvers/axisymmetric/energy_minimiser.hpp"
#include "solvers/axisymmetric/section_shape.hpp"
#include "solvers/axisymmetric/section_space.hpp"
#include "solvers/axisymmetric/swirl_law.hpp"

#include <Eigen/Core>
#include <memory>

namespace searle::solvers::axisymmetric {

/// Energies and torques of a pair of fields, in the units of SwirlLaw and bob radii, without 2 pi.
/// Whatever the fields, conjugate <= least energy <= potential, up to the quadrature's error.
struct SwirlEnergies {
    double potential{};   ///< of the rotation: from above
    double conjugate{};   ///< of the stress function: from below
    double dissipation{}; ///< the torque that the rotation's dissipation needs
    double flux{};        ///< the torque that the stress function carries
    double lower{};       ///< of the torque
    double upper{};       ///< of the torque
};

/// One division of the section with both fields on it.
class SwirlLevel {
public:
    SwirlLevel(const SectionShape& shape, SectionLines lines, int degree, int points);

    /// Takes the fields of a coarser level as the start.
    void start_from(const SwirlLevel& coarse);
    /// Minimises both energies at the given rounding (see SwirlLaw); false where Newton's method
    /// did not come to its end: the energies are still bounds.
    bool minimise(const SwirlLaw& law, double rounding, double tolerance);

    /// @param points  of the Gauss rule in each direction; the level's own, or more as a check
    [[nodiscard]] SwirlEnergies energies(const SwirlLaw& law, int points) const;
    /// The share of each element in potential - conjugate, >= 0, attributed to the intervals of its
    /// lines; those that make up `share` of the sum are marked.
    [[nodiscard]] LineMarks marks(const SwirlLaw& law, double share) const;

    [[nodiscard]] const SectionLines& lines() const { return lines_; }
    [[nodiscard]] const SectionMesh& mesh() const { return mesh_; }
    [[nodiscard]] const SectionSpace& rotation_space() const { return rotation_space_; }
    [[nodiscard]] const Eigen::VectorXd& rotation() const { return rotation_; }
    [[nodiscard]] const Eigen::VectorXd& stress_function() const { return stress_function_; }
    [[nodiscard]] int points() const { return points_; }
    [[nodiscard]] int steps() const { return steps_; }
    [[nodiscard]] long unknowns() const;

private:
    SectionLines lines_;
    SectionMesh mesh_;
    int points_;
    SectionSpace rotation_space_;
    SectionSpace stress_space_;
    EnergyMinimiser rotation_minimiser_;
    EnergyMinimiser stress_minimiser_;
    Eigen::VectorXd rotation_;
    Eigen::VectorXd stress_function_;
    int steps_{};
};

} // namespace searle::solvers::axisymmetric
