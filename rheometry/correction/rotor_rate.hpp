#pragma once

#include "geometry/instrument.hpp"
#include "rheometry/correction/wall_rate.hpp"

#include <span>
#include <vector>

namespace searle::rheometry {

/// Stress and true shear rate at the wall of the rotor, as far as the data of one curve give them.
struct RotorRates {
    std::vector<double> stresses; ///< Pa, with the sign of the torque
    WallRates rates;
};

/// Single gap and DIN bob: at the bob, by wall_rates; the DIN bob's ends are in the stress through
/// the end factor. Double gap: at the rotor's outer wall, with the stress there in a Newtonian
/// fluid; both gaps must have nearly the same ratio of radii (to 5 % of the ratio's excess over 1),
/// for then the slope of the curve belongs to both, else no rate is given. Box: speed over gap,
/// exact for every fluid.
/// @param speeds   rad/s (m/s for the box)
/// @param torques  N m (N for the box), as many
[[nodiscard]] RotorRates rotor_rates(const geometry::Instrument& instrument, double end_factor,
                                     std::span<const double> speeds,
                                     std::span<const double> torques);

} // namespace searle::rheometry
