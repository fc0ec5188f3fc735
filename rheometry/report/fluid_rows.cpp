#include "rheometry/report/number_text.hpp"
#include "rheometry/report/property_rows.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>

namespace searle::rheometry::report {

namespace {

struct ParameterLook {
    std::string_view key;
    std::string_view name;
    std::string_view symbol;
};
constexpr std::array<ParameterLook, 9> parameter_looks{
    {{"viscosity", "Viscosity", "<i>\u03b7</i>"},
     {"yield_stress", "Yield stress", "<i>\u03c4</i><sub>0</sub>"},
     {"plastic_viscosity", "Plastic viscosity", "<i>\u03b7</i><sub>p</sub>"},
     {"consistency", "Consistency", "<i>K</i>"},
     {"flow_index", "Flow index", "<i>n</i>"},
     {"zero_viscosity", "Viscosity at low rates", "<i>\u03b7</i><sub>0</sub>"},
     {"infinite_viscosity", "Viscosity at high rates", "<i>\u03b7</i><sub>\u221e</sub>"},
     {"time_constant", "Time constant", "<i>\u03bb</i>"},
     {"transition", "Transition", "<i>a</i>"}}};

struct LawLook {
    std::string_view model;
    std::string_view phrase;
    std::string_view formula; ///< HTML
};
constexpr std::array<LawLook, 7> law_looks{
    {{"newtonian", "Newtonian fluid", "<i>\u03c4</i> = <i>\u03b7</i> <i>\u03b3\u0307</i>"},
     {"bingham", "Bingham fluid",
      "<i>\u03c4</i> = <i>\u03c4</i><sub>0</sub> + <i>\u03b7</i><sub>p</sub> <i>\u03b3\u0307</i>"},
     {"power-law", "power-law fluid",
      "<i>\u03c4</i> = <i>K</i> <i>\u03b3\u0307</i><sup><i>n</i></sup>"},
     {"herschel-bulkley", "Herschel\u2013Bulkley fluid",
      "<i>\u03c4</i> = <i>\u03c4</i><sub>0</sub> + <i>K</i> "
      "<i>\u03b3\u0307</i><sup><i>n</i></sup>"},
     {"casson", "Casson fluid",
      "<i>\u03c4</i><sup>1/2</sup> = <i>\u03c4</i><sub>0</sub><sup>1/2</sup> + "
      "(<i>\u03b7</i><sub>p</sub> <i>\u03b3\u0307</i>)<sup>1/2</sup>"},
     {"carreau-yasuda", "Carreau\u2013Yasuda fluid",
      "<i>\u03b7</i> = <i>\u03b7</i><sub>\u221e</sub> + (<i>\u03b7</i><sub>0</sub> \u2212 "
      "<i>\u03b7</i><sub>\u221e</sub>) [1 + (<i>\u03bb</i><i>\u03b3\u0307</i>"
      ")<sup><i>a</i></sup>]<sup>(<i>n</i>\u22121)/<i>a</i></sup>"},
     {"cross", "Cross fluid",
      "<i>\u03b7</i> = <i>\u03b7</i><sub>\u221e</sub> + (<i>\u03b7</i><sub>0</sub> \u2212 "
      "<i>\u03b7</i><sub>\u221e</sub>) / [1 + (<i>\u03bb</i><i>\u03b3\u0307</i>"
      ")<sup>1\u2212<i>n</i></sup>]"}}};

const LawLook* find_law(std::string_view model) {
    const auto* found = std::find_if(law_looks.begin(), law_looks.end(),
                                     [&](const LawLook& look) { return look.model == model; });
    return found == law_looks.end() ? nullptr : found;
}

} // namespace

std::string fluid_phrase(std::string_view model) {
    const LawLook* look = find_law(model);
    return look ? std::string{look->phrase} : std::string{model} + " fluid";
}

std::vector<PropertyRow> fluid_rows(const ReportInput& input) {
    constexpr int digits = 8;
    std::vector<PropertyRow> rows;
    const FluidDescription& fluid = input.fluid;
    if (!fluid.model.empty()) {
        rows.push_back({"Flow law", "", escaped(fluid.model) + source_note(input, "fluid.model")});
    }
    if (const LawLook* look = find_law(fluid.model)) {
        rows.push_back({"Formula", "", std::string{look->formula}});
    }
    for (const Parameter& parameter : fluid.parameters) {
        const auto* look = std::find_if(
            parameter_looks.begin(), parameter_looks.end(),
            [&](const ParameterLook& candidate) { return candidate.key == parameter.key; });
        const bool known = look != parameter_looks.end();
        rows.push_back({known ? std::string{look->name} : escaped(parameter.key),
                        known ? std::string{look->symbol} : "",
                        escaped(quantity_text(parameter.value, parameter.unit, digits)) +
                            source_note(input, "fluid." + parameter.key)});
    }
    if (fluid.density) {
        rows.push_back({"Density", "<i>\u03c1</i>",
                        quantity_text(*fluid.density, "kg/m^3", digits) +
                            source_note(input, "fluid.density")});
    }
    return rows;
}

} // namespace searle::rheometry::report
