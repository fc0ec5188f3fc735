#pragma once

#include "geometry/instrument.hpp"
#include "laws/flow/flow_law.hpp"

#include <span>
#include <vector>

namespace searle::solvers::fit_instrument {

/// Rows of one run, in the order in which they were measured, signs included.
struct TimedRows {
    std::vector<double> times;  ///< s, strictly increasing
    std::vector<double> speeds; ///< rad/s (m/s for the box)
};

/// True when the times can carry a history: as many as speeds, three or more, strictly increasing.
[[nodiscard]] bool has_history(const TimedRows& rows);

/// What the fluid's inertia adds to the torque at each row, N m (N for the box), without the ends:
/// the transient flow in the gap (docs/radial.md) along straight lines between the rows, less the
/// steady flow at each row's speed. Before the first row the drive is taken to have come from rest
/// on the line through the first two rows, where that line reaches rest at a time >= 0; else to
/// have turned steadily at the first row's speed.
struct RampInertia {
    std::vector<double> torques;
    double relative_error{}; ///< of the transient torque, largest
    bool reached = true;     ///< the error is at most the accuracy asked for
};

/// @param accuracy  of the transient torque
[[nodiscard]] RampInertia ramp_inertia(const geometry::Instrument& instrument,
                                       const laws::flow::AnyFlowLaw& law, double density,
                                       const TimedRows& rows, double accuracy);

/// Largest share that inertia can have in the torque of a row, estimated: density d^2 times the
/// acceleration over three times the row's viscosity and speed, d the widest gap. Good to a factor
/// of a few; for the decision whether inertia is worth a computation.
/// @param viscosities  apparent ones, Pa s, > 0, per row
[[nodiscard]] double largest_inertia_share(const geometry::Instrument& instrument, double density,
                                           const TimedRows& rows,
                                           std::span<const double> viscosities);

} // namespace searle::solvers::fit_instrument
