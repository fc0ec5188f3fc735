#pragma once

#include "geometry/din_bob.hpp"
#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/progress.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace searle::solvers::meridional {

/// Torque of a bob that follows a speed history, with the fluid's inertia in swirl and secondary
/// flow.
struct TransientTorque {
    std::vector<double> torque; ///< N m, of the rows finished
    std::vector<double> error;  ///< N m, >= 0: estimate from levels of resolution in space and time
    double worst_relative_error{}; ///< over the torque, or over 1e-3 of the largest
    bool reached{};                ///< all rows are there, each as accurate as was asked
    bool interrupted{};
    int levels{};
    int elements{};                         ///< of the finest level
    long unknowns{};                        ///< of the finest level
    axisymmetric::SectionDivision division; ///< of the finest level
    long time_steps{};
    long linear_solves{}; ///< over all levels
    /// The flow at the rows asked for, as far as they were reached.
    std::vector<rheometry::fields::SectionFields> fields;
    std::string stopped; ///< why the rows end early; empty where they do not
};

/// Runs the history on finer and finer levels, in space and in time together, until two of them
/// agree to the accuracy (docs/secondary-flow.md).
/// @param law       without a yield stress: a rounded yield surface would be no answer while the
///                  rotor is slow
/// @param density   kg/m^3, > 0
/// @param accuracy  asked-for relative error of the torque, > 0
/// @param field_rows  rows whose flow is kept, from 1, increasing
[[nodiscard]] TransientTorque
transient_secondary_flow(const geometry::DinBob& bob, const laws::flow::AnyFlowLaw& law,
                         double density, const rheometry::SpeedHistory& history, double accuracy,
                         std::span<const std::size_t> field_rows = {},
                         const ProgressSink& progress = {});

} // namespace searle::solvers::meridional
