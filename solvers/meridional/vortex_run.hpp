#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace searle::solvers::meridional {

/// Torque in a gap with Taylor vortices along a speed history, per length of the gap.
struct VortexRun {
    std::vector<double> torque; ///< N, of the rows finished
    std::vector<double> error;  ///< estimate from levels of resolution in space and time, N, >= 0
    bool reached{};             ///< all rows are there, and the levels agree to the accuracy
    int levels{};
    int elements{};
    long unknowns{};
    long time_steps{};
    long linear_solves{};
    /// One vortex at the rows asked for, as far as they were reached.
    std::vector<rheometry::fields::SectionFields> fields;
    bool interrupted{}; ///< by the user, after two levels or more
    /// Sentence why rows are missing or finer levels were left alone; empty if neither.
    std::string stopped;
};

/// Follows the flow in a periodic cell in time. The vortices grow out of a rotor whose speed is
/// uneven along the axis: how soon they show depends on that, how strong they get does not.
/// A level that would take too much work is left alone; of the first one the rows so far are kept.
/// @param gap         the inner wall turns
/// @param wavelength  axial period, m
/// @param law         without a yield stress
/// @param density     kg/m^3, > 0
/// @param disturbance  unevenness, 0 < disturbance << 1
/// @param accuracies  asked-for relative error of each row's torque; as many as rows, at least one
/// @param field_rows  rows whose flow is kept, from 1, increasing
/// May throw Interrupted, if fewer than two levels are done: then no row has an error yet.
[[nodiscard]] VortexRun vortex_run(const radial::AnnularGap& gap, double wavelength,
                                   const laws::flow::AnyFlowLaw& law, double density,
                                   double disturbance, const rheometry::SpeedHistory& history,
                                   std::span<const double> accuracies,
                                   std::span<const std::size_t> field_rows = {},
                                   const ProgressSink& progress = {});

} // namespace searle::solvers::meridional
