#include "rheometry/report/describe_fluid.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <variant>

namespace searle::rheometry::report {

namespace {

// A law's parameters in the order of its members, which is the order of Law::parameters.
template <class Law>
auto values_of(const Law& law) {
    constexpr std::size_t count = Law::parameters.size();
    static_assert(count >= 1 && count <= 5, "a law with more parameters needs a line here");
    if constexpr (count == 1) {
        const auto& [a] = law;
        return std::array<double, 1>{a};
    } else if constexpr (count == 2) {
        const auto& [a, b] = law;
        return std::array<double, 2>{a, b};
    } else if constexpr (count == 3) {
        const auto& [a, b, c] = law;
        return std::array<double, 3>{a, b, c};
    } else if constexpr (count == 4) {
        const auto& [a, b, c, d] = law;
        return std::array<double, 4>{a, b, c, d};
    } else {
        const auto& [a, b, c, d, e] = law;
        return std::array<double, 5>{a, b, c, d, e};
    }
}

} // namespace

FluidDescription describe_fluid(const laws::flow::AnyFlowLaw& law, std::optional<double> density) {
    FluidDescription fluid;
    fluid.density = density;
    std::visit(
        [&](const auto& chosen) {
            fluid.model = std::string{chosen.name};
            const auto values = values_of(chosen);
            for (std::size_t k = 0; k < values.size(); ++k) {
                const auto& parameter = chosen.parameters[k];
                fluid.parameters.push_back(
                    {std::string{parameter.key}, values[k], std::string{parameter.unit}});
            }
            fluid.true_stress = [chosen](double rate) { return double{chosen.stress(rate)}; };
        },
        law);
    return fluid;
}

} // namespace searle::rheometry::report
