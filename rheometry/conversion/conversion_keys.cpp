#include "rheometry/conversion/conversion_keys.hpp"

namespace searle::rheometry {

casefile::Keys<ConversionSettings> conversion_keys() {
    casefile::Keys<ConversionSettings> keys;
    keys.choice<std::optional<RateDefinition> ConversionSettings::*, RateDefinition>(
            "definition", &ConversionSettings::definition,
            {{"bob-wall", RateDefinition::bob_wall, "values at the bob's wall"},
             {"iso-3219", RateDefinition::iso_3219, "mean of the two wall values"},
             {"mean-radius", RateDefinition::mean_radius, "values at the mean radius"}})
        .defaults_to("bob-wall for the single gap, iso-3219 for the others")
        .says("Which shear rate and stress of the gap are reported.");
    keys.custom(
            "end_factor",
            [](ConversionSettings& settings, const casefile::Value& value) {
                settings.end_factor_computed = std::holds_alternative<std::string>(value.is);
                casefile::Slot<std::optional<double>>::store(settings.end_factor, value);
            },
            [](const ConversionSettings& settings) -> std::optional<casefile::Value> {
                if (settings.end_factor_computed)
                    return casefile::Value{std::string{"computed"}};
                return casefile::Slot<std::optional<double>>::load(settings.end_factor);
            })
        .is_number()
        .above("0")
        .at_most("100")
        .word("computed", "of this bob and fluid")
        .example("1")
        .defaults_to("1.1 for the DIN bob, else 1; the box has none")
        .says("c_L: the torque of the real bob over that of one without ends.");
    return keys;
}

} // namespace searle::rheometry
