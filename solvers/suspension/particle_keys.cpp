#include "casefile/reading.hpp"
#include "solvers/suspension/suspension_keys.hpp"

#include <cmath>
#include <fmt/format.h>

namespace searle::solvers::suspension {
namespace {

casefile::Keys<SizeClass> size_class_keys() {
    casefile::Keys<SizeClass> keys;
    keys.key("diameter", &SizeClass::diameter)
        .measures(casefile::length)
        .above("0 m")
        .required()
        .example("1 um")
        .says("Diameter of these particles.");
    keys.key("share", &SizeClass::share)
        .measures(casefile::fraction)
        .is_number()
        .above("0")
        .at_most("1")
        .required()
        .example("0.5")
        .says("Their share of the particles' volume.");
    return keys;
}

void add_size_keys(casefile::Keys<ParticleSettings>& keys) {
    keys.key("diameter", &ParticleSettings::diameter)
        .measures(casefile::length)
        .above("0 m")
        .example("1.5 um")
        .defaults_to("none; this or diameters is given")
        .says("Diameter, when all particles are alike.");
    keys.tables("diameters", &ParticleSettings::diameters, size_class_keys())
        .says("Sizes of a mixture with their shares by volume, in place of diameter.");
    keys.key("spread", &ParticleSettings::spread)
        .is_number()
        .at_least("0")
        .at_most("1")
        .example("0.2")
        .says(
            "Lognormal sizes: standard deviation of ln(diameter) by number, each size the median.");
    keys.key("density", &ParticleSettings::density)
        .measures(casefile::density)
        .above("0 kg/m^3")
        .at_most("1e6 kg/m^3")
        .required()
        .example("5700 kg/m^3")
        .says("Mass per volume of the particles.");
    keys.key("volume_fraction", &ParticleSettings::volume_fraction)
        .measures(casefile::fraction)
        .is_number()
        .above("0")
        .below("0.74")
        .required()
        .example("0.0468")
        .says("The particles' share of the volume.");
}

void add_model_keys(casefile::Keys<ParticleSettings>& keys) {
    keys.choice<ParticleBoundary ParticleSettings::*, ParticleBoundary>(
            "boundary", &ParticleSettings::boundary,
            {{"walls", ParticleBoundary::walls, "two walls, one moving"},
             {"lees-edwards", ParticleBoundary::lees_edwards, "bulk, no walls"}})
        .example("walls")
        .says("What bounds the suspension.");
    keys.table("contact", &ParticleSettings::contact, contact_keys())
        .says("Contacts; left out, they are not computed.");
    keys.table("dlvo", &ParticleSettings::dlvo, colloid_keys())
        .says("Colloidal forces; left out, they are not computed.");
    keys.choice<Drag ParticleSettings::*, Drag>("drag", &ParticleSettings::drag,
                                                {{"stokes", Drag::stokes, ""},
                                                 {"di-felice", Drag::di_felice, ""},
                                                 {"ergun-wen-yu", Drag::ergun_wen_yu, ""}})
        .example("di-felice")
        .says("The drag law.");
    keys.choice<Hydrodynamics ParticleSettings::*, Hydrodynamics>(
            "hydrodynamics", &ParticleSettings::hydrodynamics,
            {{"auto", Hydrodynamics::automatic, ""},
             {"drag", Hydrodynamics::drag, ""},
             {"stresslet", Hydrodynamics::stresslet, ""},
             {"lubrication", Hydrodynamics::lubrication, ""}})
        .example("auto")
        .says("How much of the particles' effect on the flow is computed.");
    keys.key("brownian", &ParticleSettings::brownian)
        .is_boolean()
        .example("false")
        .says("Thermal motion.");
    keys.key("temperature", &ParticleSettings::temperature)
        .measures(casefile::temperature)
        .above("0 K")
        .at_most("10000 K")
        .example("20 degC")
        .says("Temperature, for the thermal motion and the double layer.");
}

void add_step_keys(casefile::Keys<ParticleSettings>& keys) {
    keys.choice<Integrator ParticleSettings::*, Integrator>(
            "integrator", &ParticleSettings::integrator,
            {{"auto", Integrator::automatic, ""},
             {"explicit", Integrator::explicit_steps, ""},
             {"implicit-drag", Integrator::implicit_drag, ""},
             {"overdamped", Integrator::overdamped, ""}})
        .example("auto")
        .says("How the particles' motion is integrated.");
    keys.key("time_step", &ParticleSettings::time_step)
        .measures(casefile::duration)
        .above("0 s")
        .example("1 ns")
        .or_absent_as("auto", "as accuracy and stability ask for")
        .says("Step of the particles' motion.");
    keys.key("seed", &ParticleSettings::seed)
        .is_integer()
        .at_least("0")
        .at_most("9e15")
        .example("1")
        .says("Start of the random numbers; the same seed gives the same result.");
    keys.custom(
            "gravity",
            [](ParticleSettings& particles, const casefile::Value& value) {
                constexpr double standard_gravity = 9.80665;
                if (const bool* on = std::get_if<bool>(&value.is))
                    particles.gravity = *on ? std::optional{standard_gravity} : std::nullopt;
                else
                    particles.gravity = std::get<double>(value.is);
            },
            [](const ParticleSettings& particles) -> std::optional<casefile::Value> {
                return particles.gravity ? casefile::Value{*particles.gravity}
                                         : casefile::Value{false};
            })
        .measures(casefile::acceleration)
        .is_boolean()
        .at_least("0 m/s^2")
        .at_most("1e6 m/s^2")
        .example("false")
        .says("Weight of the particles: an acceleration, or true for 9.80665 m/s^2.");
    keys.key("shear_modulus", &ParticleSettings::shear_modulus)
        .measures(casefile::stress)
        .above("0 Pa")
        .example("77 GPa")
        .defaults_to("none")
        .says("Of the particles, for hertz and the Rayleigh time.");
    keys.key("poisson_ratio", &ParticleSettings::poisson_ratio)
        .is_number()
        .above("-1")
        .below("0.5")
        .example("0.3")
        .defaults_to("none")
        .says("Of the particles, for hertz and the Rayleigh time.");
}

void check_sizes(const ParticleSettings& particles, casefile::Findings& findings) {
    if (particles.diameter && !particles.diameters.empty())
        findings.contradiction({"diameters", "diameter"}, "the size is given twice",
                               "diameter or diameters");
    if (!findings.given("diameter") && !findings.given("diameters"))
        findings.contradiction({"diameter", "diameters"}, "the size of the particles is missing",
                               "diameter or diameters");
    double sum = 0.0;
    for (const SizeClass& size : particles.diameters)
        sum += size.share;
    if (!particles.diameters.empty() && std::abs(sum - 1.0) > 1e-6)
        findings.contradiction({"diameters"}, fmt::format("the shares sum to {:.6g}", sum),
                               "shares that sum to 1");
}

void check_material(const ParticleSettings& particles, casefile::Findings& findings) {
    if (!particles.contact || particles.contact->model != ContactModel::hertz)
        return;
    for (const char* key : {"shear_modulus", "poisson_ratio"})
        if (!findings.given(key))
            findings.contradiction({key, "contact"},
                                   fmt::format("contact.model = \"hertz\" needs the {} of the "
                                               "particles",
                                               key),
                                   "shear_modulus and poisson_ratio");
}

} // namespace

casefile::Keys<ParticleSettings> particle_keys() {
    casefile::Keys<ParticleSettings> keys;
    add_size_keys(keys);
    add_model_keys(keys);
    add_step_keys(keys);
    keys.check(check_sizes);
    keys.check(check_material);
    return keys;
}

casefile::Keys<CouplingSettings> coupling_keys() {
    casefile::Keys<CouplingSettings> keys;
    keys.key("cells", &CouplingSettings::cells)
        .is_integer()
        .at_least("1")
        .at_most("10000")
        .is_list(3, 3)
        .example("[8, 8, 8]")
        .says("Cells along the flow, across the gap and along the vorticity.");
    keys.choice<CouplingModel CouplingSettings::*, CouplingModel>(
            "model", &CouplingSettings::model,
            {{"A", CouplingModel::a, "the pressure acts on both phases"},
             {"B", CouplingModel::b, "the pressure acts on the fluid"}})
        .example("A")
        .says("Form of the coupled equations.");
    keys.key("interval", &CouplingSettings::interval)
        .is_integer()
        .at_least("1")
        .at_most("1000000")
        .example("10")
        .or_absent_as("auto", "as the two time scales ask for")
        .says("Particle steps per fluid step.");
    return keys;
}

} // namespace searle::solvers::suspension
