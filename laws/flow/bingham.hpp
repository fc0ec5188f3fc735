#pragma once

#include "laws/flow/law_concept.hpp"

namespace searle::laws::flow {

/// stress = yield_stress + plastic_viscosity * rate. Bingham 1922.
/// yield_stress, Pa, >= 0; plastic_viscosity, Pa s, > 0.
/// Limits: yield_stress = 0 is Newtonian.
template <class Scalar = double>
struct BinghamLaw {
    static constexpr std::string_view name = "bingham";
    static constexpr std::array parameters{ParameterName{"yield_stress", "Pa"},
                                           ParameterName{"plastic_viscosity", "Pa.s"}};

    Scalar yield_stress{};
    Scalar plastic_viscosity{};

    [[nodiscard]] const Scalar& yield_stress_value() const { return yield_stress; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        return plastic_viscosity * rate;
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return yield_stress + excess_stress(rate);
    }
    template <class Stress>
    [[nodiscard]] auto rate_at_excess(const Stress& excess) const {
        return excess / plastic_viscosity;
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& /*rate*/) const {
        return plastic_viscosity;
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        return 1.0 / (1.0 + yield_stress / excess_stress(rate));
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using Bingham = BinghamLaw<double>;

} // namespace searle::laws::flow
