#include "solvers/suspension/step_limits.hpp"

#include "laws/colloid/dlvo.hpp"
#include "laws/contact/rayleigh_time.hpp"
#include "laws/drag/stokes.hpp"
#include "solvers/suspension/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace searle::solvers::suspension {
namespace {

/// Shares that the step keeps to at an asked accuracy of 2e-3.
constexpr double contact_share = 0.3;   ///< of drag / (2 k_n)
constexpr double duration_share = 0.02; ///< of a contact's duration, explicit steps
constexpr double explicit_share = 0.1;  ///< of the particles' relaxation time
constexpr double rayleigh_share = 0.2;  ///< of the Rayleigh time, explicit steps
constexpr double colloid_share = 0.5; ///< of drag / k, k the colloid's largest stiffness: stability
constexpr double strain_share = 2e-3; ///< strain within a step
constexpr double error_share = 1e-3;  ///< displacement error over the range of the forces
constexpr double start_share = 1e-2;  ///< of the relaxation time, first step beside a colloid

double smallest(const particles::Column& column) {
    return *std::min_element(column.begin(), column.end());
}

double largest_stiffness(const particles::AnyColloid& colloid, double radius) {
    return std::visit(
        [radius]<class Colloid>(const Colloid& chosen) {
            if constexpr (std::is_same_v<Colloid, particles::NoColloid>)
                return 0.0;
            else
                return laws::colloid::dlvo_curve(chosen, radius, radius).largest_stiffness;
        },
        colloid);
}

/// Overlap to which shear presses two particles: by the drag on them, or by their inertia.
double overlap_in_shear(const laws::contact::AnyContact& contact, double viscosity, double rate,
                        double radius, double mass) {
    const auto* hertz = std::get_if<laws::contact::Hertz>(&contact);
    if (hertz == nullptr)
        return 0.0; // its spring is the same at any overlap
    const double speed = 2.0 * radius * rate;
    return std::max(
        hertz->overlap_under(6.0 * std::numbers::pi * viscosity * radius * speed, 0.5 * radius),
        hertz->deepest_overlap(speed, 0.5 * radius, 0.5 * mass));
}

} // namespace

double step_scale(double accuracy) { return std::clamp(accuracy / 2e-3, 0.02, 3.0); }

StepLimits::StepLimits(const SuspensionInput& input)
    : contact_(contact_law(input.settings)),
      explicit_steps_(input.settings.integrator == Integrator::explicit_steps) {
    const double scale = step_scale(input.accuracy);
    const double least_radius = smallest(input.particles.radius);
    const double least_mass = smallest(input.particles.mass);
    const double rate = input.fastest_wall_speed / input.box.length_y;
    drag_ = laws::drag::Stokes{input.viscosity, 0.0}.coefficient(least_radius, 0, 1);
    contact_time_scale_ = scale * contact_share;
    reduced_mass_ = 0.5 * least_mass;
    reduced_radius_ = input.particles.largest_radius();
    free_ = scale * strain_share / rate;
    if (explicit_steps_) {
        free_ = std::min(free_, explicit_share * least_mass / drag_);
        if (input.settings.shear_modulus)
            free_ =
                std::min(free_, rayleigh_share * laws::contact::rayleigh_time(
                                                     least_radius, input.settings.density,
                                                     *input.settings.shear_modulus,
                                                     input.settings.poisson_ratio.value_or(0.3)));
    }
    if (contact_)
        foreseen_overlap_ = overlap_in_shear(
            *contact_, input.viscosity, rate, reduced_radius_,
            *std::max_element(input.particles.mass.begin(), input.particles.mass.end()));
    start_ = free_;
    displacement_error_ = std::numeric_limits<double>::infinity();
    if (input.settings.dlvo) {
        if (const double stiffness = largest_stiffness(
                colloid_law(input.settings.dlvo, input.settings.temperature), least_radius);
            stiffness > 0.0)
            free_ = std::min(free_, std::min(scale, 1.0) * colloid_share * drag_ / stiffness);
        displacement_error_ = error_share * scale * scale *
                              debye_length(*input.settings.dlvo, input.settings.temperature);
        start_ = std::min(free_, start_share * least_mass / drag_);
    }
    start_ = std::min(start_, touching(0.0));
    stable_ = explicit_steps_ ? 2.0 * least_mass / drag_ : std::numeric_limits<double>::infinity();
    if (contact_ && !input.settings.dlvo) {
        const laws::contact::ContactSpring spring = spring_at(2.0 * foreseen_overlap_);
        // Two particles against each other; a dashpot helps like the drag.
        const double swings =
            explicit_steps_ ? 2.0 * std::sqrt(0.5 * least_mass / spring.slope)
                            : std::max(longest_stable_step(2.0 * spring.slope, least_mass, drag_),
                                       0.5 * (drag_ + 2.0 * spring.damping) / spring.slope);
        stable_ = std::min(stable_, swings);
    }
}

laws::contact::ContactSpring StepLimits::spring_at(double overlap) const {
    return std::visit(
        [&](const auto& law) { return law.at(overlap, reduced_radius_, reduced_mass_); },
        *contact_);
}

double StepLimits::touching(double overlap) const {
    if (!contact_)
        return free_;
    const laws::contact::ContactSpring spring =
        spring_at(2.0 * std::max(overlap, foreseen_overlap_));
    double longest =
        std::min(free_, contact_time_scale_ * 0.5 * (drag_ + 2.0 * spring.damping) / spring.slope);
    if (explicit_steps_)
        longest = std::min(longest, duration_share * spring.duration(reduced_mass_));
    return longest;
}

} // namespace searle::solvers::suspension
