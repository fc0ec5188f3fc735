#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/axisymmetric/section_shape.hpp"
#include "solvers/progress.hpp"

#include <span>
#include <string>
#include <vector>

namespace searle::solvers::axisymmetric {

/// Torque along a speed history in the whole section, any flow law, without secondary flow.
struct SwirlHistory {
    std::vector<double> torque; ///< N m, of the rows finished
    std::vector<double> error;  ///< estimate, N m, >= 0
    double worst_relative_error{};
    bool reached{};
    bool interrupted{};
    std::vector<bool> rests; ///< rheometry::TorqueRow::rests
    double steady_defect{};  ///< of the last level's largest steady torque, over the known one
    int levels{};
    int elements{};
    long unknowns{};
    long time_steps{};        ///< of the last level
    long newton_steps{};      ///< over all levels
    SectionDivision division; ///< of the last level
    std::string stopped;      ///< why the last level did not end, or empty
    /// The flow at the rows asked for.
    std::vector<rheometry::fields::SectionFields> fields;
};

/// What the steady flows at the rows' speeds carry, N m, and its error; 0 at rest.
struct SteadyTorques {
    std::span<const double> torque;
    std::span<const double> error;
};

/// Levels of rising degree, smaller elements at the rotor, smaller steps and a sharper yield
/// surface until two of them agree to the accuracy (SwirlStepper; docs/axisymmetric.md). A level
/// gives what a row's torque differs by from the steady one at its speed, both on this level: what
/// elements and rounding miss is alike in both, and the steady torque is known better.
/// @param density   kg/m^3, > 0
/// @param accuracy  relative to each row's torque, or to 1e-3 of the largest where that is more
/// @param field_rows  numbers from 1, increasing
[[nodiscard]] SwirlHistory
swirl_history(const SectionShape& shape, const laws::flow::AnyFlowLaw& law, double density,
              const rheometry::SpeedHistory& history, double accuracy, const SteadyTorques& steady,
              std::span<const std::size_t> field_rows, const ProgressSink& progress = {});

} // namespace searle::solvers::axisymmetric
