#pragma once

#include <optional>
#include <span>

namespace searle::rheometry {

/// Herschel-Bulkley law stress = yield_stress + consistency rate^flow_index, as fitted to the slow
/// end of a measured curve only to tell whether the fluid at the cup moved. A negative yield stress
/// is a fit's way to say that there is none.
struct PlugFlowLaw {
    double yield_stress{}; ///< Pa
    double consistency{};  ///< Pa s^n, > 0
    double flow_index{};   ///< > 0

    /// Shear rate at a stress, 1/s; 0 at or below the yield stress.
    [[nodiscard]] double rate(double stress) const;
    /// d rate / d stress, 1/(Pa s); 0 at or below the yield stress.
    [[nodiscard]] double rate_slope(double stress) const;
};

/// Speed of the bob for a stress at the bob: 1/2 integral of rate(q)/q dq from max(yield stress,
/// stress / delta^2) to stress. rad/s; 0 at or below the yield stress. Relative error < 1e-8 for
/// flow indices from 0.1 to 2.
/// @param delta  R_cup / R_bob, > 1
[[nodiscard]] double bob_speed(const PlugFlowLaw& law, double bob_stress, double delta);

/// The inverse of bob_speed. @param omega rad/s, > 0
[[nodiscard]] double bob_stress(const PlugFlowLaw& law, double omega, double delta);

struct PlugFlowFit {
    PlugFlowLaw law;
    double yield_standard_error{}; ///< Pa, from the residuals
    double residual{};             ///< root mean square of ln(stress of the law / measured stress)
};

/// Least squares in ln(stress) over all points; the gap flow, plug included, is evaluated exactly.
/// No value when there are fewer than 6 points or the search does not settle.
/// @param omega       rad/s, > 0, increasing
/// @param bob_stress  Pa, > 0
/// @param weights     number of measurements behind each point
[[nodiscard]] std::optional<PlugFlowFit> fit_plug_flow(std::span<const double> omega,
                                                       std::span<const double> bob_stress,
                                                       std::span<const double> weights,
                                                       double delta);

} // namespace searle::rheometry
