#pragma once

#include "laws/flow/law_concept.hpp"

namespace searle::laws::flow {

/// sqrt(stress) = sqrt(yield_stress) + sqrt(plastic_viscosity * rate). Casson 1959, in
/// Rheology of Disperse Systems (ed. Mill), 84.
/// yield_stress, Pa, >= 0; plastic_viscosity, Pa s, > 0.
/// Limits: yield_stress = 0 is Newtonian.
template <class Scalar = double>
struct CassonLaw {
    static constexpr std::string_view name = "casson";
    static constexpr std::array parameters{ParameterName{"yield_stress", "Pa"},
                                           ParameterName{"plastic_viscosity", "Pa.s"}};

    Scalar yield_stress{};
    Scalar plastic_viscosity{};

    [[nodiscard]] const Scalar& yield_stress_value() const { return yield_stress; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        using std::sqrt;
        const auto viscous = plastic_viscosity * rate;
        return viscous + 2.0 * sqrt(yield_stress * viscous);
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return yield_stress + excess_stress(rate);
    }
    /// (sqrt(yield + excess) - sqrt(yield))^2 / plastic_viscosity, written without cancellation.
    template <class Stress>
    [[nodiscard]] auto rate_at_excess(const Stress& excess) const {
        using std::sqrt;
        if (!(excess > 0.0)) {
            return 0.0 * excess / plastic_viscosity;
        }
        const auto root = excess / (sqrt(yield_stress + excess) + sqrt(yield_stress));
        return root * root / plastic_viscosity;
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& rate) const {
        using std::sqrt;
        return plastic_viscosity + sqrt(yield_stress * plastic_viscosity / rate);
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        using std::sqrt;
        return 1.0 / (1.0 + sqrt(yield_stress / (plastic_viscosity * rate)));
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using Casson = CassonLaw<double>;

} // namespace searle::laws::flow
