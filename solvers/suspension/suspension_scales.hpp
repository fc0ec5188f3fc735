#pragma once

#include "laws/colloid/dlvo.hpp"
#include "solvers/plan_forecast.hpp"
#include "solvers/suspension/suspension_settings.hpp"

namespace searle::solvers::suspension {

struct Sizes {
    double smallest{}, largest{}; ///< diameters, m; of a lognormal spread four deviations up
    double mean_volume{};         ///< m^3, by number
};

[[nodiscard]] Sizes sizes_of(const ParticleSettings& settings);

/// 1/s, of the rows; 0 without rows.
[[nodiscard]] double fastest_rate(const Forecast& forecast);
/// 1/s, of the rows that are not at rest.
[[nodiscard]] double slowest_rate(const Forecast& forecast);

/// Extremes of two equal spheres' colloidal forces; zeros without.
/// @param radius      m
/// @param attraction  set to the force that pulls them together when they touch, N
[[nodiscard]] laws::colloid::DlvoCurve curve_of(const ParticleSettings& settings, double radius,
                                                double& attraction);

} // namespace searle::solvers::suspension
