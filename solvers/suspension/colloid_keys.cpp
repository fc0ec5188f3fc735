#include "casefile/reading.hpp"
#include "solvers/suspension/suspension_keys.hpp"

namespace searle::solvers::suspension {

casefile::Keys<ContactSettings> contact_keys() {
    casefile::Keys<ContactSettings> keys;
    keys.choice<ContactModel ContactSettings::*, ContactModel>(
            "model", &ContactSettings::model,
            {{"hooke", ContactModel::hooke, "linear springs and dashpots"},
             {"hertz", ContactModel::hertz, "elastic spheres of shear_modulus and poisson_ratio"}})
        .example("hooke")
        .says("The contact law.");
    keys.key("stiffness", &ContactSettings::stiffness)
        .measures(casefile::spring_stiffness)
        .above("0 N/m")
        .example("1e-2 N/m")
        .defaults_to("none; hooke needs it")
        .says("Stiffness of hooke's normal spring.");
    keys.custom(
            "restitution",
            [](ContactSettings& contact, const casefile::Value& value) {
                casefile::Slot<double>::store(contact.restitution, value);
            },
            [](const ContactSettings& contact) {
                // A damping takes its place, also in the case as resolved.
                return contact.damping ? std::nullopt
                                       : std::optional{casefile::Value{contact.restitution}};
            })
        .is_number()
        .above("0")
        .at_most("1")
        .example("0.9")
        .says("Speed after over speed before a head-on contact.");
    keys.key("friction", &ContactSettings::friction)
        .is_number()
        .at_least("0")
        .at_most("100")
        .example("0.3")
        .says("Coulomb's friction coefficient.");
    keys.key("tangential_stiffness", &ContactSettings::tangential_stiffness)
        .measures(casefile::spring_stiffness)
        .above("0 N/m")
        .example("3e-3 N/m")
        .or_absent_as("auto", "follows from stiffness")
        .says("Stiffness of hooke's tangential spring.");
    keys.key("damping", &ContactSettings::damping)
        .measures(casefile::dashpot)
        .at_least("0 kg/s")
        .example("1e-9 kg/s")
        .or_absent_as("auto", "follows from restitution")
        .says("Dashpot beside the normal spring, in place of restitution.");
    keys.key("rolling_friction", &ContactSettings::rolling_friction)
        .is_number()
        .at_least("0")
        .at_most("100")
        .example("0")
        .says("Coefficient of rolling friction.");
    keys.check([](const ContactSettings& contact, casefile::Findings& findings) {
        const bool is_hertz = contact.model == ContactModel::hertz;
        if (!is_hertz && !findings.given("stiffness"))
            findings.contradiction({"stiffness", "model"},
                                   "the stiffness of hooke's spring is missing",
                                   "a stiffness, such as \"1e-2 N/m\", or model = \"hertz\"");
        for (const char* key : {"stiffness", "tangential_stiffness"})
            if (is_hertz && findings.given(key))
                findings.contradiction({key, "model"},
                                       "hertz takes its stiffness from the particles' material",
                                       "particles.shear_modulus and particles.poisson_ratio");
        if (contact.damping && findings.given("restitution"))
            findings.contradiction({"damping", "restitution"}, "the damping is given twice",
                                   "damping or restitution");
    });
    return keys;
}

casefile::Keys<ColloidSettings> colloid_keys() {
    casefile::Keys<ColloidSettings> keys;
    keys.choice<DoubleLayer ColloidSettings::*, DoubleLayer>(
            "double_layer", &ColloidSettings::double_layer,
            {{"weak-overlap", DoubleLayer::weak_overlap, "linear superposition"},
             {"constant-potential", DoubleLayer::constant_potential,
              "Hogg, Healy and Fuerstenau 1966"}})
        .example("weak-overlap")
        .says("The form of the repulsion.");
    keys.key("hamaker", &ColloidSettings::hamaker)
        .measures(casefile::energy)
        .at_least("0 J")
        .required()
        .example("6e-20 J")
        .says("Hamaker constant.");
    keys.key("zeta_potential", &ColloidSettings::zeta_potential)
        .measures(casefile::voltage)
        .at_least("-1 V")
        .at_most("1 V")
        .required()
        .example("32 mV")
        .says("Potential at the particles' surface.");
    keys.key("debye_length", &ColloidSettings::debye_length)
        .measures(casefile::length)
        .above("0 m")
        .example("10 nm")
        .defaults_to("none; this or ionic_strength is given")
        .says("Decay length of the double layer.");
    keys.key("ionic_strength", &ColloidSettings::ionic_strength)
        .measures(casefile::concentration)
        .above("0 mol/m^3")
        .example("1 mmol/l")
        .defaults_to("none; this or debye_length is given")
        .says("Ionic strength, in place of debye_length.");
    keys.key("relative_permittivity", &ColloidSettings::relative_permittivity)
        .is_number()
        .at_least("1")
        .at_most("1000")
        .example("80.1")
        .says("Of the fluid.");
    keys.key("minimum_separation", &ColloidSettings::minimum_separation)
        .measures(casefile::length)
        .above("0 m")
        .example("0.3 nm")
        .says("Surface distance below which both forces stay at their value there.");
    keys.key("cutoff", &ColloidSettings::cutoff)
        .measures(casefile::length)
        .above("0 m")
        .example("100 nm")
        .says("Surface distance beyond which both forces are left out.");
    keys.check([](const ColloidSettings& colloid, casefile::Findings& findings) {
        if (colloid.debye_length && colloid.ionic_strength)
            findings.contradiction({"ionic_strength", "debye_length"},
                                   "the double layer's thickness is given twice",
                                   "debye_length or ionic_strength");
        if (!colloid.debye_length && !colloid.ionic_strength)
            findings.contradiction({"debye_length", "ionic_strength"},
                                   "the double layer's thickness is missing",
                                   "debye_length or ionic_strength");
        if (colloid.cutoff <= colloid.minimum_separation)
            findings.contradiction({"cutoff", "minimum_separation"},
                                   "the cut-off is not beyond the minimum separation",
                                   "minimum_separation < cutoff");
    });
    return keys;
}

} // namespace searle::solvers::suspension
