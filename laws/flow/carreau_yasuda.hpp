#pragma once

#include "laws/flow/invert_monotone.hpp"
#include "laws/flow/law_concept.hpp"

#include <algorithm>
#include <limits>

namespace searle::laws::flow {

/// viscosity = infinite + (zero - infinite) [1 + (time_constant rate)^transition]^((n-1)/transition),
/// n = flow_index. Yasuda, Armstrong & Cohen 1981, Rheol. Acta 20, 163, eq. 8.
/// zero_viscosity, Pa s, > 0; infinite_viscosity, Pa s, 0 ... zero_viscosity; time_constant, s, > 0;
/// flow_index, 1, > 0; transition, 1, > 0 (2 is Carreau's law).
/// Limits: zero_viscosity as rate -> 0, slope n in log-log where the infinite viscosity is small.
template <class Scalar = double>
struct CarreauYasudaLaw {
    static constexpr std::string_view name = "carreau-yasuda";
    static constexpr std::array parameters{
        ParameterName{"zero_viscosity", "Pa.s"}, ParameterName{"infinite_viscosity", "Pa.s"},
        ParameterName{"time_constant", "s"}, ParameterName{"flow_index", "1"},
        ParameterName{"transition", "1"}};

    Scalar zero_viscosity{};
    Scalar infinite_viscosity{};
    Scalar time_constant{};
    Scalar flow_index{};
    Scalar transition{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Rate>
    [[nodiscard]] auto viscosity(const Rate& rate) const {
        using std::pow;
        const auto bend = 1.0 + pow(time_constant * rate, transition);
        return infinite_viscosity + (zero_viscosity - infinite_viscosity) *
                                        pow(bend, (flow_index - 1.0) / transition);
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
        const auto power = pow(time_constant * rate, transition);
        const auto falling = (zero_viscosity - infinite_viscosity) *
                             pow(1.0 + power, (flow_index - 1.0) / transition);
        return 1.0 + (flow_index - 1.0) * (falling / (infinite_viscosity + falling)) *
                         (power / (1.0 + power));
    }
    [[nodiscard]] double rate_at_excess(double excess) const {
        if (!(excess > 0.0)) {
            return 0.0;
        }
        const double newtonian = excess / zero_viscosity;
        // Below both plateaus' power law: viscosity >= zero (1 + power)^(..) for thinning laws.
        double other = newtonian;
        while (stress(other) < excess) {
            other *= 8.0;
        }
        double lower = newtonian;
        while (stress(lower) > excess) {
            lower *= 0.125;
        }
        return invert_monotone(*this, excess, lower, std::max(other, lower));
    }
    [[nodiscard]] double sharpness() const {
        return std::max(1.0, static_cast<double>(transition));
    }
};
using CarreauYasuda = CarreauYasudaLaw<double>;

} // namespace searle::laws::flow
