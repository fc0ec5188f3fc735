#pragma once

#include "laws/flow/law_concept.hpp"

namespace searle::laws::flow {

/// stress = viscosity * rate. Newton 1687.
/// viscosity, Pa s, > 0.
template <class Scalar = double>
struct NewtonianLaw {
    static constexpr std::string_view name = "newtonian";
    static constexpr std::array parameters{ParameterName{"viscosity", "Pa.s"}};

    Scalar viscosity{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        return viscosity * rate;
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return excess_stress(rate);
    }
    template <class Stress>
    [[nodiscard]] auto rate_at_excess(const Stress& excess) const {
        return excess / viscosity;
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& /*rate*/) const {
        return viscosity;
    }
    template <class Rate>
    [[nodiscard]] double log_slope(const Rate& /*rate*/) const {
        return 1.0;
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using Newtonian = NewtonianLaw<double>;

} // namespace searle::laws::flow
