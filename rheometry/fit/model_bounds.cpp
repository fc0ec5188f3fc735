#include "rheometry/fit/model.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry::fit {
namespace {

/// Far beyond anything that the data can tell apart.
constexpr double beyond = 1e6;

void bound(Parameter& parameter, const DataScale& scale) {
    const std::string& key = parameter.key;
    const auto physical = [&](double low, double high) {
        parameter.low = low;
        parameter.high = high;
        parameter.low_is_physical = true;
    };
    const auto searched = [&](double low, double high) {
        parameter.low = low;
        parameter.high = high;
    };
    if (key == "yield_stress") {
        // Casson's derivative by the root of the yield stress has no value at 0 itself.
        const bool rooted = parameter.transform == Transform::square_root;
        physical(rooted ? 1e-28 * scale.highest_stress : 0.0, 2.0 * scale.highest_stress);
    } else if (key == "extrapolated_stress") {
        physical(0.0, 10.0 * scale.highest_stress);
    } else if (key == "viscosity" || key == "plastic_viscosity") {
        searched(scale.lowest_viscosity / beyond, scale.highest_viscosity * beyond);
    } else if (key == "zero_viscosity") {
        searched(0.1 * scale.lowest_viscosity, scale.highest_viscosity * beyond);
    } else if (key == "infinite_viscosity") {
        const bool searched_as_logarithm = parameter.transform == Transform::logarithm;
        physical(searched_as_logarithm ? scale.lowest_viscosity / beyond : 0.0,
                 10.0 * scale.highest_viscosity);
    } else if (key == "consistency") {
        // consistency = stress / rate^n with n between the bounds of the flow index.
        const double swing =
            std::max(std::abs(std::log(scale.lowest_rate)), std::abs(std::log(scale.highest_rate)));
        const double reach = std::min(600.0, 5.0 * swing + std::log(beyond));
        searched(scale.lowest_stress * std::exp(-reach), scale.highest_stress * std::exp(reach));
    } else if (key == "time_constant") {
        searched(1e-4 / scale.highest_rate, 1e4 / scale.lowest_rate);
    } else if (key == "characteristic_rate") {
        searched(1e-3 * scale.lowest_rate, 1e3 * scale.highest_rate);
    } else if (key == "half_stress") {
        searched(1e-6 * scale.lowest_stress, 1e4 * scale.highest_stress);
    } else if (key == "exponent") {
        physical(1.0, 20.0);
    } else if (key == "transition") {
        searched(0.1, 20.0);
    }
}

} // namespace

DataScale scale_of(std::span<const double> rates, std::span<const double> stresses) {
    DataScale scale{.lowest_rate = rates[0],
                    .highest_rate = rates[0],
                    .lowest_stress = stresses[0],
                    .highest_stress = stresses[0],
                    .lowest_viscosity = stresses[0] / rates[0],
                    .highest_viscosity = stresses[0] / rates[0]};
    for (std::size_t k = 1; k < rates.size(); ++k) {
        const double viscosity = stresses[k] / rates[k];
        scale.lowest_rate = std::min(scale.lowest_rate, rates[k]);
        scale.highest_rate = std::max(scale.highest_rate, rates[k]);
        scale.lowest_stress = std::min(scale.lowest_stress, stresses[k]);
        scale.highest_stress = std::max(scale.highest_stress, stresses[k]);
        scale.lowest_viscosity = std::min(scale.lowest_viscosity, viscosity);
        scale.highest_viscosity = std::max(scale.highest_viscosity, viscosity);
    }
    return scale;
}

std::vector<Parameter> parameters_for(const Model& model, const DataScale& scale) {
    std::vector<Parameter> parameters = model.parameters;
    for (Parameter& parameter : parameters) {
        bound(parameter, scale);
        if (parameter.key != "flow_index")
            continue;
        if (model.name == "carreau-yasuda" || model.name == "cross") {
            // The law of a fluid whose viscosity falls from one plateau to the other.
            const bool open = model.name == "cross";
            parameter.low = open ? 1e-3 : 0.0;
            parameter.high = open ? 0.999 : 1.0;
            parameter.low_is_physical = true;
            parameter.high_is_physical = true;
        } else {
            parameter.low = model.name == "sisko" ? 0.0 : 0.01;
            parameter.high = 5.0;
            parameter.low_is_physical = true;
        }
    }
    return parameters;
}

bool within_definition(const Model& model, std::span<const double> values) {
    if (model.name == "carreau-yasuda" || model.name == "cross")
        return values[1] <= values[0];
    if (model.name == "windhab")
        return values[1] >= values[0];
    return true;
}

} // namespace searle::rheometry::fit
