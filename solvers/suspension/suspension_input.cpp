#include "solvers/suspension/suspension_input.hpp"

#include "laws/colloid/double_layer.hpp"

namespace searle::solvers::suspension {
namespace {

template <class Layer>
laws::colloid::Dlvo<Layer> dlvo_of(const ColloidSettings& settings, double temperature) {
    laws::colloid::Dlvo<Layer> dlvo;
    dlvo.attraction.hamaker = settings.hamaker;
    dlvo.layer.permittivity = settings.relative_permittivity * laws::colloid::vacuum_permittivity;
    dlvo.layer.potential = settings.zeta_potential;
    dlvo.layer.inverse_thickness = 1.0 / debye_length(settings, temperature);
    dlvo.minimum_separation = settings.minimum_separation;
    dlvo.cutoff = settings.cutoff;
    return dlvo;
}

} // namespace

std::optional<laws::contact::AnyContact> contact_law(const ParticleSettings& settings) {
    if (!settings.contact)
        return std::nullopt;
    const ContactSettings& contact = *settings.contact;
    const double ratio = contact.damping ? 0.0 : laws::contact::damping_ratio(contact.restitution);
    const double damping = contact.damping.value_or(0.0);
    if (contact.model == ContactModel::hertz)
        return laws::contact::Hertz{.shear_modulus = *settings.shear_modulus,
                                    .poisson_ratio = *settings.poisson_ratio,
                                    .damping_ratio = ratio,
                                    .damping = damping,
                                    .friction = contact.friction,
                                    .rolling_friction = contact.rolling_friction};
    const double stiffness = *contact.stiffness;
    return laws::contact::Hooke{.normal_stiffness = stiffness,
                                .tangential_stiffness =
                                    contact.tangential_stiffness.value_or(2.0 / 7.0 * stiffness),
                                .damping_ratio = ratio,
                                .damping = damping,
                                .friction = contact.friction,
                                .rolling_friction = contact.rolling_friction};
}

std::string_view stiffness_key(const ParticleSettings& settings) {
    return settings.contact && settings.contact->model == ContactModel::hertz
               ? "particles.shear_modulus"
               : "particles.contact.stiffness";
}

double debye_length(const ColloidSettings& settings, double temperature) {
    return settings.debye_length
               ? *settings.debye_length
               : laws::colloid::debye_length(settings.relative_permittivity, temperature,
                                             *settings.ionic_strength);
}

particles::AnyColloid colloid_law(const std::optional<ColloidSettings>& settings,
                                  double temperature) {
    if (!settings)
        return particles::NoColloid{};
    if (settings->double_layer == DoubleLayer::constant_potential)
        return dlvo_of<laws::colloid::ConstantPotential>(*settings, temperature);
    return dlvo_of<laws::colloid::WeakOverlap>(*settings, temperature);
}

} // namespace searle::solvers::suspension
