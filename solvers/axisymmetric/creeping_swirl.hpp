#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/axisymmetric/section_shape.hpp"
#include "solvers/progress.hpp"

#include <memory>

namespace searle::solvers::axisymmetric {

class SwirlLevel;

struct CreepingSettings {
    /// Asked-for relative error of the torque, > 0.
    double accuracy = 1e-3;
    /// The bracket itself is to be as narrow as `accuracy` (its width over the torque); otherwise
    /// the estimate from both fields and two levels is enough.
    bool certified = false;
    int most_levels = 12;
    long most_unknowns = 120'000; ///< of both fields together
    /// Newton steps times unknowns, over all levels, beyond which no further level is begun: some
    /// seconds.
    double most_work = 6e6;
};

/// Steady swirl without inertia around a DIN bob that turns in its cup, ends included.
struct CreepingTorque {
    double torque{};     ///< N m, > 0
    double error{};      ///< estimate of its numerical error, N m
    double lower{};      ///< bounds of the exact torque, N m: equilibrated stress from below and
    double upper{};      ///< compatible rates from above, up to the error of the quadrature
    double end_factor{}; ///< c_L: over the torque of the same length of an endless bob
    /// Change of the bounds when a finer Gauss rule takes the energies, over the torque; the bounds
    /// are those of the finer rule.
    double quadrature_error{};
    double energy_gap{}; ///< (potential - conjugate) / potential
    bool reached{};      ///< `error`, or the bracket's width, is as small as was asked
    int levels{};
    int elements{};           ///< of the finest level
    int newton_steps{};       ///< over all levels and both fields
    double work{};            ///< over all levels, as CreepingSettings::most_work
    long unknowns{};          ///< of the finest level, both fields
    SectionDivision division; ///< of the finest level
};

/// Solves for the torque at one speed, refining until the accuracy is reached
/// (docs/axisymmetric.md). No flow law is regularised: rounding of the yield surface is a parameter
/// of the path, and the energies are the exact law's.
/// @param speed  rad/s, > 0
/// May throw Interrupted, from `progress`.
[[nodiscard]] CreepingTorque creeping_torque(const SectionShape& shape,
                                             const laws::flow::AnyFlowLaw& law, double speed,
                                             const CreepingSettings& settings,
                                             const ProgressSink& progress = {});

/// The torque with the fields of the finest level, for pictures.
struct CreepingSwirl {
    CreepingTorque torque;
    std::shared_ptr<const SwirlLevel> level;
    double stress_scale{}; ///< Pa, of the level's stress function
};
[[nodiscard]] CreepingSwirl creeping_swirl(const SectionShape& shape,
                                           const laws::flow::AnyFlowLaw& law, double speed,
                                           const CreepingSettings& settings,
                                           const ProgressSink& progress = {});

/// What a yield-stress fluid at rest holds at the most, N m, to some per cent: the torque of a flow
/// whose stress at the rotor is a hundredth above the yield stress. May throw Interrupted.
[[nodiscard]] double stopping_torque(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                                     const ProgressSink& progress = {});

} // namespace searle::solvers::axisymmetric
