#pragma once

#include "casefile/keys.hpp"
#include "laws/flow/flow_law.hpp"

namespace searle::laws::flow {

[[nodiscard]] casefile::Keys<Newtonian> newtonian_keys();
[[nodiscard]] casefile::Keys<Bingham> bingham_keys();
[[nodiscard]] casefile::Keys<PowerLaw> power_law_keys();
[[nodiscard]] casefile::Keys<HerschelBulkley> herschel_bulkley_keys();
[[nodiscard]] casefile::Keys<Casson> casson_keys();
[[nodiscard]] casefile::Keys<CarreauYasuda> carreau_yasuda_keys();
[[nodiscard]] casefile::Keys<Cross> cross_keys();

/// Adds the key that chooses the law, and each law's own keys, to the keys of a struct that holds
/// it.
/// @param law  pointer to the member of type AnyFlowLaw
template <class Target>
void add_flow_law_keys(casefile::Keys<Target>& keys, AnyFlowLaw Target::*law) {
    keys.selector("model", "The flow law: shear stress from shear rate.");
    keys.alternative("newtonian", "viscosity x rate", law, newtonian_keys());
    keys.alternative("bingham", "yield_stress + plastic_viscosity x rate", law, bingham_keys());
    keys.alternative("power-law", "consistency x rate^flow_index", law, power_law_keys());
    keys.alternative("herschel-bulkley", "yield_stress + consistency x rate^flow_index", law,
                     herschel_bulkley_keys());
    keys.alternative("casson", "(sqrt(yield_stress) + sqrt(plastic_viscosity x rate))^2", law,
                     casson_keys());
    keys.alternative("carreau-yasuda",
                     "from zero_viscosity to infinite_viscosity around the rate 1/time_constant",
                     law, carreau_yasuda_keys());
    keys.alternative("cross",
                     "from zero_viscosity to infinite_viscosity around the rate 1/time_constant",
                     law, cross_keys());
}

} // namespace searle::laws::flow
