#pragma once

#include "laws/contact/contact_law.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"
#include "solvers/suspension/suspension_settings.hpp"

#include <optional>
#include <string_view>

namespace searle::solvers::suspension {

/// All that a motion needs to start.
struct SuspensionInput {
    particles::ParticleStore particles; ///< without overlap
    particles::ShearBox box;
    ParticleSettings settings; ///< hydrodynamics and integrator are none of them "auto"
    CouplingSettings coupling;
    double viscosity{};          ///< of the fluid, Pa s
    double density{};            ///< of the fluid, kg/m^3
    double accuracy{};           ///< asked-for relative error; decides the step
    double initial_wall_speed{}; ///< m/s; particles and fluid start in this uniform shear
    double fastest_wall_speed{}; ///< m/s, > 0
    int threads = 1;
};

/// The contact law of the settings; none where they have none. Hooke's tangential spring is 2/7 of
/// the normal one where it is not given (Silbert et al. 2001).
[[nodiscard]] std::optional<laws::contact::AnyContact>
contact_law(const ParticleSettings& settings);

/// The key of a case that makes the contact stiffer or softer.
[[nodiscard]] std::string_view stiffness_key(const ParticleSettings& settings);

/// @param temperature K, for a Debye length that follows from the ionic strength
[[nodiscard]] particles::AnyColloid colloid_law(const std::optional<ColloidSettings>& settings,
                                                double temperature);

/// 1/kappa of the settings, m.
[[nodiscard]] double debye_length(const ColloidSettings& settings, double temperature);

} // namespace searle::solvers::suspension
