#include "rheometry/fit/starting_values.hpp"

#include <string_view>

namespace searle::rheometry::fit {

std::vector<std::string_view> contained_in(const Model& model) {
    const std::string_view name = model.name;
    if (name == "newtonian")
        return {};
    if (name == "herschel-bulkley")
        return {"newtonian", "bingham", "power-law"};
    if (name == "windhab")
        return {"newtonian", "bingham"};
    if (name == "sisko")
        return {"newtonian", "power-law"};
    return {"newtonian"};
}

std::vector<double> embedded(const Model& simpler, std::span<const double> values,
                             const Model& model, double middle_rate) {
    const std::string_view from = simpler.name;
    const std::string_view into = model.name;
    if (from == into)
        return {values.begin(), values.end()};
    if (from == "newtonian") {
        const double viscosity = values[0];
        if (into == "bingham" || into == "casson")
            return {0.0, viscosity};
        if (into == "power-law")
            return {viscosity, 1.0};
        if (into == "herschel-bulkley" || into == "sisko")
            return {0.0, viscosity, 1.0};
        if (into == "carreau-yasuda")
            return {viscosity, viscosity, 1.0 / middle_rate, 0.5, 2.0};
        if (into == "cross")
            return {viscosity, viscosity, 1.0 / middle_rate, 0.5};
        if (into == "ellis")
            return {2.0 * viscosity, viscosity * middle_rate, 1.0};
        if (into == "windhab")
            return {0.0, 0.0, viscosity, middle_rate};
    }
    if (from == "bingham") {
        if (into == "herschel-bulkley")
            return {values[0], values[1], 1.0};
        if (into == "windhab")
            return {values[0], values[0], values[1], middle_rate};
    }
    if (from == "power-law" && (into == "herschel-bulkley" || into == "sisko"))
        return {0.0, values[0], values[1]};
    return {};
}

} // namespace searle::rheometry::fit
