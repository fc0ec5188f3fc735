#pragma once

#include "geometry/instrument.hpp"
#include "solvers/radial/gap_grid.hpp"

#include <vector>

namespace searle::solvers::radial {

/// One gap of an instrument as the transient solver sees it.
struct RotorGap {
    GapShape shape;
    /// Drive torque (N m; N for the box) per flux F at the moving wall, sign included: the fluid
    /// pulls an inner rotor back with -2 pi L F and an outer one with +2 pi L F. The ONLY place
    /// that turns a flux into an instrument's torque.
    double torque_per_flux{};
};

/// The gaps on either side of an instrument's rotor, without its ends: one for the single gap, the
/// DIN bob's cylinder and the box, two for the double gap.
[[nodiscard]] std::vector<RotorGap> rotor_gaps(const geometry::Instrument& instrument,
                                               double density);

} // namespace searle::solvers::radial
