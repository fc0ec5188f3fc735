#pragma once

#include "rheometry/suspension_stress.hpp"

#include <optional>
#include <vector>

namespace searle::rheometry {

/// One row of what an instrument measures. "Torque" is the torque that the drive must apply to the
/// rotor, about +z, of the whole instrument (N m), positive when the fluid resists a positive
/// speed; for the box it is the force on the moving wall (N) and "speed" is m/s.
struct TorqueRow {
    double time{};         ///< s; see SpeedHistory and SteadySpeeds
    double speed{};        ///< rad/s (m/s for the box)
    double torque{};       ///< N m (N for the box)
    double torque_error{}; ///< estimate of the numerical error of `torque`, same unit, >= 0
    /// The rotor stands still and a yield stress holds the fluid: the law leaves the torque open
    /// between the yield torques. `torque` is one of them (of a slow ramp down the one that it ends
    /// with), `torque_error` covers all, and no accuracy is asked of the row.
    bool rests{};
    /// Inertia-free torque at this speed, for the regime and the report.
    double steady_torque{};
    /// Outermost (for an inner rotor) radius that is sheared, m; the wall's radius when all is
    /// sheared. Of the steady flow at this speed. For the double gap: of the outer gap. For the
    /// box: 0.
    double yield_radius{};
    /// Shear rate of the steady flow at the rotor's wall, 1/s, >= 0.
    double rotor_wall_rate{};
    /// Of a suspension; none for a fluid without particles.
    std::optional<SuspensionStress> suspension = std::nullopt;
};

struct TorqueHistory {
    std::vector<TorqueRow> rows;
};

} // namespace searle::rheometry
