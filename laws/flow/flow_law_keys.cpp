#include "laws/flow/flow_law_keys.hpp"

#include "casefile/reading.hpp"

namespace searle::laws::flow {
namespace {

using casefile::Findings;
using casefile::Key;
using casefile::Keys;

template <class Law>
Key& yield_stress_key(Keys<Law>& keys) {
    return keys.key("yield_stress", &Law::yield_stress)
        .measures(casefile::stress)
        .at_least("0 Pa")
        .at_most("1e12 Pa")
        .required()
        .example("5 Pa")
        .says("Stress below which the fluid does not flow; 0 is allowed.");
}

template <class Law>
Key& viscosity_key(Keys<Law>& keys, const char* name, double Law::*member) {
    return keys.key(name, member)
        .measures(casefile::viscosity)
        .above("0 Pa.s")
        .at_most("1e15 Pa.s");
}

template <class Law>
Key& consistency_key(Keys<Law>& keys) {
    return keys.key("consistency", &Law::consistency)
        .measures(casefile::consistency)
        .above("0 Pa.s^n")
        .at_most("1e15 Pa.s^n")
        .required()
        .example("0.5 Pa.s^n")
        .says("K: the (excess) stress at a rate of 1 1/s; n is the flow_index.");
}

template <class Law>
Key& flow_index_key(Keys<Law>& keys) {
    return keys.key("flow_index", &Law::flow_index)
        .is_number()
        .at_least("0.01")
        .at_most("10")
        .required()
        .example("0.5");
}

/// The keys that Carreau-Yasuda and Cross share.
template <class Law>
void add_plateau_keys(Keys<Law>& keys) {
    viscosity_key(keys, "zero_viscosity", &Law::zero_viscosity)
        .required()
        .example("1 Pa.s")
        .says("Viscosity at rest.");
    viscosity_key(keys, "infinite_viscosity", &Law::infinite_viscosity)
        .at_least("0 Pa.s")
        .example("0 Pa.s")
        .says("Viscosity at infinite rate, at most zero_viscosity.");
    keys.key("time_constant", &Law::time_constant)
        .measures(casefile::duration)
        .above("0 s")
        .at_most("1e12 s")
        .required()
        .example("0.1 s")
        .says("One over the rate around which the viscosity falls.");
    keys.check([](const Law& law, Findings& findings) {
        if (law.infinite_viscosity > law.zero_viscosity)
            findings.contradiction({"infinite_viscosity", "zero_viscosity"},
                                   "the viscosity at infinite rate is above the one at rest",
                                   "infinite_viscosity <= zero_viscosity");
    });
}

} // namespace

Keys<Newtonian> newtonian_keys() {
    Keys<Newtonian> keys;
    viscosity_key(keys, "viscosity", &Newtonian::viscosity)
        .required()
        .example("1.0016 mPa.s")
        .says("Dynamic viscosity; water at 20 degC has 1.0016 mPa.s.");
    return keys;
}

Keys<Bingham> bingham_keys() {
    Keys<Bingham> keys;
    yield_stress_key(keys);
    viscosity_key(keys, "plastic_viscosity", &Bingham::plastic_viscosity)
        .required()
        .example("20 mPa.s")
        .says("Slope of the stress over the rate.");
    return keys;
}

Keys<PowerLaw> power_law_keys() {
    Keys<PowerLaw> keys;
    consistency_key(keys);
    flow_index_key(keys).says("n: below 1 shear-thinning, above 1 shear-thickening.");
    return keys;
}

Keys<HerschelBulkley> herschel_bulkley_keys() {
    Keys<HerschelBulkley> keys;
    yield_stress_key(keys);
    consistency_key(keys);
    flow_index_key(keys).says("n: below 1 shear-thinning, above 1 shear-thickening.");
    return keys;
}

Keys<Casson> casson_keys() {
    Keys<Casson> keys;
    yield_stress_key(keys);
    viscosity_key(keys, "plastic_viscosity", &Casson::plastic_viscosity)
        .required()
        .example("20 mPa.s")
        .says("Viscosity at infinite rate.");
    return keys;
}

Keys<CarreauYasuda> carreau_yasuda_keys() {
    Keys<CarreauYasuda> keys{{.transition = 2.0}};
    add_plateau_keys(keys);
    flow_index_key(keys).says("n: log-log slope of the stress where the viscosity falls.");
    keys.key("transition", &CarreauYasuda::transition)
        .is_number()
        .at_least("0.01")
        .at_most("100")
        .example("2")
        .says("Sharpness of the bend (Yasuda's a); 2 is Carreau's law.");
    return keys;
}

Keys<Cross> cross_keys() {
    Keys<Cross> keys;
    add_plateau_keys(keys);
    flow_index_key(keys).at_least("0.01").below("1").says(
        "n: the viscosity falls as rate^(n - 1); 1 - n is Cross's exponent.");
    return keys;
}

} // namespace searle::laws::flow
