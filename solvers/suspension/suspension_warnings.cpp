#include "solvers/suspension/suspension_warnings.hpp"

#include "laws/colloid/double_layer.hpp"
#include "solvers/plan_text.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/suspension/suspension_scales.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace searle::solvers::suspension {
namespace {

/// Overlap over the radius at which spheres still count as hard.
constexpr double hard_overlap = 1e-3;
/// A contact that costs less than this factor in steps is not worth a word.
constexpr double worth_saying = 3.0;

/// That softer spheres would give the same stress at a fraction of the steps; empty where not.
std::string about_hertz(const ParticleSettings& settings, double radius, double viscosity,
                        double rate) {
    const auto contact = contact_law(settings);
    if (!contact || settings.hydrodynamics == Hydrodynamics::lubrication)
        return "";
    const auto* hertz = std::get_if<laws::contact::Hertz>(&*contact);
    if (hertz == nullptr)
        return "";
    const double force = 12.0 * std::numbers::pi * viscosity * radius * radius * rate;
    const double overlap = hertz->overlap_under(force, 0.5 * radius) / radius;
    // overlap ~ G^(-2/3), slope of the force and with it 1 / step ~ G^(2/3).
    const double factor = hard_overlap / overlap;
    if (!(factor > worth_saying))
        return "";
    return fmt::format(
        "Shear presses spheres of this shear modulus in by {:.2g} radii. With {:.2g} "
        "Pa it would be {:.0e}, still hard to the flow, at steps up to {:.2g} times "
        "as long.",
        overlap, hertz->shear_modulus / std::pow(factor, 1.5), hard_overlap, factor);
}

} // namespace

std::vector<std::string> warnings_for(const Scene& scene, const Forecast& forecast,
                                      const SuspensionChoice& choice) {
    std::vector<std::string> warnings;
    const ParticleSettings& settings = choice.settings;
    const double viscosity = std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
    const double radius = 0.5 * sizes_of(settings).largest;
    const double thermal = laws::colloid::boltzmann * settings.temperature;
    if (settings.hydrodynamics == Hydrodynamics::drag)
        warnings.push_back(fmt::format(
            "hydrodynamics = \"drag\" carries no particle stress: Einstein's 2.5 phi, {} of the "
            "stress here, is missing (\"stresslet\" or \"auto\" has it).",
            percent(2.5 * choice.volume_fraction)));
    if (settings.hydrodynamics == Hydrodynamics::stresslet &&
        5.0 * choice.volume_fraction * choice.volume_fraction > scene.solver.accuracy)
        warnings.push_back(fmt::format(
            "Isolated stresslets leave out the hydrodynamics of pairs, about 5 phi^2 = {} of the "
            "stress; hydrodynamics = \"lubrication\" has it.",
            percent(5.0 * choice.volume_fraction * choice.volume_fraction)));
    if (settings.dlvo) {
        double attraction = 0.0;
        const laws::colloid::DlvoCurve curve = curve_of(settings, radius, attraction);
        if (curve.barrier < thermal)
            warnings.push_back(fmt::format(
                "The double layer leaves no barrier against the attraction ({:.2g} kT): the "
                "suspension will aggregate.",
                curve.barrier / thermal));
        const auto contact = contact_law(settings);
        const double pressed =
            contact
                ? std::visit(
                      [&](const auto& law) { return law.overlap_under(attraction, 0.5 * radius); },
                      *contact)
                : 0.0;
        if (pressed > 0.1 * radius)
            warnings.push_back(fmt::format("Pairs that pass the barrier attract each other with "
                                           "{:.2g} N, which presses the contact in by {:.2g} "
                                           "radii: should pairs get there, the run stops. A "
                                           "stiffer contact ({}) or a larger minimum_separation "
                                           "holds them.",
                                           attraction, pressed / radius, stiffness_key(settings)));
        if (settings.dlvo->cutoff < 5.0 * debye_length(*settings.dlvo, settings.temperature))
            warnings.push_back(
                "dlvo.cutoff is less than five Debye lengths: more than 0.7 % of the "
                "double layer's force at contact is cut off.");
    }
    if (const std::string text = about_hertz(settings, radius, viscosity, fastest_rate(forecast));
        !text.empty())
        warnings.push_back(text);
    const double peclet =
        6 * std::numbers::pi * viscosity * std::pow(radius, 3) * slowest_rate(forecast) / thermal;
    if (!settings.brownian && peclet < 10.0)
        warnings.push_back(fmt::format(
            "The Peclet number falls to {:.2g}: thermal motion, which brownian = false leaves out, "
            "matters there.",
            peclet));
    return warnings;
}

} // namespace searle::solvers::suspension
