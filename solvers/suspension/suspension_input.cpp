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

std::optional<laws::contact::Hooke> contact_law(const std::optional<ContactSettings>& settings) {
    if (!settings)
        return std::nullopt;
    return laws::contact::Hooke{
        .normal_stiffness = settings->stiffness,
        .tangential_stiffness =
            settings->tangential_stiffness.value_or(2.0 / 7.0 * settings->stiffness),
        .damping_ratio =
            settings->damping ? 0.0 : laws::contact::damping_ratio(settings->restitution),
        .damping = settings->damping.value_or(0.0),
        .friction = settings->friction,
        .rolling_friction = settings->rolling_friction};
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
