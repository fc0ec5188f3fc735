#pragma once

#include "laws/flow/law_concept.hpp"

#include <algorithm>

namespace searle::laws::flow {

/// stress = yield_stress + consistency * rate^flow_index. Herschel & Bulkley 1926,
/// Kolloid-Zeitschrift 39, 291.
/// yield_stress, Pa, >= 0; consistency, Pa s^n, > 0; flow_index, 1, > 0.
/// Limits: yield_stress = 0 is the power law, flow_index = 1 is Bingham.
template <class Scalar = double>
struct HerschelBulkleyLaw {
    static constexpr std::string_view name = "herschel-bulkley";
    static constexpr std::array parameters{ParameterName{"yield_stress", "Pa"},
                                           ParameterName{"consistency", "Pa.s^n"},
                                           ParameterName{"flow_index", "1"}};

    Scalar yield_stress{};
    Scalar consistency{};
    Scalar flow_index{};

    [[nodiscard]] const Scalar& yield_stress_value() const { return yield_stress; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        using std::pow;
        return consistency * pow(rate, flow_index);
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return yield_stress + excess_stress(rate);
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
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        return flow_index / (1.0 + yield_stress / excess_stress(rate));
    }
    [[nodiscard]] double sharpness() const {
        return std::max(1.0, static_cast<double>(flow_index));
    }
};
using HerschelBulkley = HerschelBulkleyLaw<double>;

} // namespace searle::laws::flow
