#pragma once

#include "laws/flow/invert_monotone.hpp"
#include "laws/flow/law_concept.hpp"

#include <algorithm>

namespace searle::laws::flow {

/// viscosity = infinite + (zero - infinite) / [1 + (time_constant rate)^(1 - flow_index)].
/// Cross 1965, J. Colloid Sci. 20, 417, with the exponent written as 1 - n, so that n is the
/// log-log slope of stress against rate in the power-law region, as in the other laws.
/// zero_viscosity, Pa s, > 0; infinite_viscosity, Pa s, 0 ... zero_viscosity; time_constant, s, > 0;
/// flow_index, 1, 0 < n < 1.
template <class Scalar = double>
struct CrossLaw {
    static constexpr std::string_view name = "cross";
    static constexpr std::array parameters{
        ParameterName{"zero_viscosity", "Pa.s"}, ParameterName{"infinite_viscosity", "Pa.s"},
        ParameterName{"time_constant", "s"}, ParameterName{"flow_index", "1"}};

    Scalar zero_viscosity{};
    Scalar infinite_viscosity{};
    Scalar time_constant{};
    Scalar flow_index{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Rate>
    [[nodiscard]] auto viscosity(const Rate& rate) const {
        using std::pow;
        return infinite_viscosity + (zero_viscosity - infinite_viscosity) /
                                        (1.0 + pow(time_constant * rate, 1.0 - flow_index));
    }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        return viscosity(rate) * rate;
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return excess_stress(rate);
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& rate) const {
        return viscosity(rate) * log_slope(rate);
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        using std::pow;
        const auto power = pow(time_constant * rate, 1.0 - flow_index);
        const auto falling = (zero_viscosity - infinite_viscosity) / (1.0 + power);
        return 1.0 - (1.0 - flow_index) * (falling / (infinite_viscosity + falling)) *
                         (power / (1.0 + power));
    }
    [[nodiscard]] double rate_at_excess(double excess) const {
        if (!(excess > 0.0)) {
            return 0.0;
        }
        const double lower = excess / zero_viscosity;
        double upper = lower;
        while (stress(upper) < excess) {
            upper *= 8.0;
        }
        return invert_monotone(*this, excess, lower, upper);
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using Cross = CrossLaw<double>;

} // namespace searle::laws::flow
