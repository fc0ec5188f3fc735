#pragma once

#include "solvers/plan.hpp"
#include "solvers/plan_forecast.hpp"
#include "solvers/suspension/suspension_settings.hpp"

namespace searle::solvers::suspension {

/// The settings with every "auto" decided.
struct SuspensionChoice {
    ParticleSettings settings;
    double volume_fraction{};
    double count{}; ///< of particles, about
    std::string why_hydrodynamics;
    std::string why_integrator;
};

/// Decides hydrodynamics and integrator: stresslets of isolated spheres up to
/// 5 phi^2 <= the asked accuracy, pairs beyond (Batchelor & Green 1972: the phi^2 term is 5
/// to 7.6).
[[nodiscard]] SuspensionChoice choose(const Scene& scene);

/// Completes a plan for a scene with particles: model, items, warnings, cost. Throws
/// UnsuitableScene where the particles do not fit the box.
void plan_suspension(const Scene& scene, Forecast& forecast, Plan& plan);

} // namespace searle::solvers::suspension
