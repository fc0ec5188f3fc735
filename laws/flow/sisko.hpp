#pragma once

#include "laws/flow/invert_monotone.hpp"
#include "laws/flow/law_concept.hpp"

#include <algorithm>

namespace searle::laws::flow {

/// stress = infinite_viscosity * rate + consistency * rate^flow_index. Sisko 1958, Ind. Eng. Chem.
/// 50, 1789.
/// infinite_viscosity, Pa s, >= 0; consistency, Pa s^n, > 0; flow_index, 1, > 0 (below 1 for a
/// shear-thinning fluid; infinite_viscosity is then the viscosity at high rates).
/// Limits: infinite_viscosity = 0 is the power law. Validity: infinite viscosity at rest.
template <class Scalar = double>
struct SiskoLaw {
    static constexpr std::string_view name = "sisko";
    static constexpr std::array parameters{ParameterName{"infinite_viscosity", "Pa.s"},
                                           ParameterName{"consistency", "Pa.s^n"},
                                           ParameterName{"flow_index", "1"}};

    Scalar infinite_viscosity{};
    Scalar consistency{};
    Scalar flow_index{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        using std::pow;
        return infinite_viscosity * rate + consistency * pow(rate, flow_index);
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return excess_stress(rate);
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& rate) const {
        using std::pow;
        return infinite_viscosity + consistency * flow_index * pow(rate, flow_index - 1.0);
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        using std::pow;
        const auto linear = infinite_viscosity * pow(rate, 1.0 - flow_index);
        return (linear + consistency * flow_index) / (linear + consistency);
    }
    [[nodiscard]] double rate_at_excess(double excess) const {
        using std::pow;
        if (!(excess > 0.0)) {
            return 0.0;
        }
        // Either term alone carries at most the stress, and one of them at least half of it.
        const double by_power = pow(excess / consistency, 1.0 / flow_index);
        const double by_half = pow(0.5 * excess / consistency, 1.0 / flow_index);
        if (!(infinite_viscosity > 0.0)) {
            return by_power;
        }
        return invert_monotone(*this, excess, std::min(by_half, 0.5 * excess / infinite_viscosity),
                               std::min(by_power, excess / infinite_viscosity));
    }
    [[nodiscard]] double sharpness() const {
        return std::max(1.0, static_cast<double>(flow_index));
    }
};
using Sisko = SiskoLaw<double>;
static_assert(FlowLaw<Sisko>);

} // namespace searle::laws::flow
