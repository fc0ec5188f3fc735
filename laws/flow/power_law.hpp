#pragma once

#include "laws/flow/law_concept.hpp"

namespace searle::laws::flow {

/// stress = consistency * rate^flow_index. Ostwald 1925, de Waele 1923.
/// consistency, Pa s^n, > 0; flow_index, 1, > 0 (below 1 shear-thinning).
/// Limits: flow_index = 1 is Newtonian. Validity: both ends of the rate axis are unphysical
/// (infinite viscosity at rest, none at infinite rate).
template <class Scalar = double>
struct PowerLawLaw {
    static constexpr std::string_view name = "power-law";
    static constexpr std::array parameters{ParameterName{"consistency", "Pa.s^n"},
                                           ParameterName{"flow_index", "1"}};

    Scalar consistency{};
    Scalar flow_index{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        using std::pow;
        return consistency * pow(rate, flow_index);
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return excess_stress(rate);
    }
    template <class Stress>
    [[nodiscard]] auto rate_at_excess(const Stress& excess) const {
        using std::pow;
        return pow(excess / consistency, 1.0 / flow_index);
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& rate) const {
        using std::pow;
        return consistency * flow_index * pow(rate, flow_index - 1.0);
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& /*rate*/) const {
        return flow_index;
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using PowerLaw = PowerLawLaw<double>;

} // namespace searle::laws::flow
