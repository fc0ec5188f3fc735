#pragma once

#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "rheometry/torque_history.hpp"
#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/scene.hpp"

#include <string>
#include <vector>

namespace searle::solvers::radial {

/// What the radial solver did, as data.
struct RadialReport {
    rheometry::TorqueHistory
        history;                   ///< rows finished, in order; fewer than asked when interrupted
    bool transient{};              ///< false: inertia was left out
    bool reached = true;           ///< every row meets the asked accuracy by its own estimate
    double worst_relative_error{}; ///< largest estimate over the rows, relative to the stress scale
    double worst_torque_imbalance{}; ///< GapRun::momentum_defect of the finest level
    int refinements{};               ///< number of grid levels solved
    int elements{};                  ///< of the finest level, per gap
    long time_steps{};               ///< of the finest level
    long linear_solves{};            ///< over all levels
    long unknowns{};
    bool interrupted{};
    std::vector<std::string> notes;
    /// The flow at some rows, in order; where the case asks for it (output.fields).
    std::vector<rheometry::fields::SectionFields> fields;
};

/// Says how many rows rest (rheometry::TorqueRow), if any.
void note_rest(RadialReport& report);

/// The rows whose fields a case asks for, numbers from 1: none unless output.fields.
/// @param finished  rows there are
[[nodiscard]] std::vector<std::size_t> rows_with_fields(const OutputSettings& output,
                                                        std::size_t finished);

/// Torque history of the instrument without its ends: steady flow row by row for a steady series
/// and where the plan found inertia negligible, else the transient flow in the gap. For the DIN bob
/// the endless cylinder's torque times the conversion's end factor.
/// @param plan  of the same scene: plan.transient decides, plan.rows hold the times of a steady
/// series
[[nodiscard]] RadialReport solve_radial(const Scene& scene, const Plan& plan,
                                        const ProgressSink& progress);

/// Steady torque (N m; N for the box) of the endless instrument at one speed, and its gap flow.
/// Odd in the speed; 0 at rest.
struct SteadyInstrumentFlow {
    double torque{};
    double relative_error{};
    double
        rotor_wall_rate{}; ///< 1/s, at the bob, at the rotor's outer wall, at the box's walls; >= 0
    double yield_radius{}; ///< m, as TorqueRow::yield_radius
    bool partly_sheared{};
};
[[nodiscard]] SteadyInstrumentFlow steady_instrument_flow(const geometry::Instrument& instrument,
                                                          const laws::flow::AnyFlowLaw& law,
                                                          double speed);

} // namespace searle::solvers::radial
