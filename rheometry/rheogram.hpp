#pragma once

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/torque_history.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace searle::rheometry {

/// One point of a flow curve. Rate and stress carry the conversion's definition.
struct RheogramPoint {
    double time{};           ///< s
    double speed{};          ///< rad/s (m/s for the box)
    double torque{};         ///< N m (N for the box)
    double shear_rate{};     ///< 1/s
    double shear_stress{};   ///< Pa
    double viscosity{};      ///< shear_stress / shear_rate, Pa s; NaN at zero rate
    double stress_error{};   ///< numerical error estimate of shear_stress, Pa, >= 0
    std::string regime;      ///< names joined by '+', see solvers/regime.hpp
    double steady_stress{};  ///< shear stress without inertia at this speed, Pa
    double bob_shear_rate{}; ///< true shear rate of the steady flow at the rotor's wall, 1/s
    double yield_radius{};   ///< see TorqueRow
    std::optional<SuspensionStress> suspension = std::nullopt; ///< see TorqueRow
};

struct Rheogram {
    std::vector<RheogramPoint> points;
};

/// Lifts a torque history to a rheogram: the one place where torques become stresses and speeds
/// become rates. A negative speed gives a negative rate and, with a torque that resists, a negative
/// stress and a positive viscosity.
/// @param regimes         one per row of `history`
/// @param bob_shear_rates 1/s, one per row, or empty: the column is then NaN
/// Throws std::invalid_argument when a length differs from the number of rows.
[[nodiscard]] Rheogram make_rheogram(const TorqueHistory& history, const Conversion& conversion,
                                     std::span<const std::string> regimes,
                                     std::span<const double> bob_shear_rates = {});

} // namespace searle::rheometry
