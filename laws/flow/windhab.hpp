#pragma once

#include "laws/flow/law_concept.hpp"

#include <cmath>
#include <limits>

namespace searle::laws::flow {

/// stress = yield_stress + (extrapolated_stress - yield_stress) [1 - exp(-rate /
/// characteristic_rate)] + infinite_viscosity * rate. Windhab 1993, in ICA report on the rheology
/// of chocolate; IOCCC method 46 (2000).
/// yield_stress, Pa, >= 0; extrapolated_stress, Pa, >= yield_stress: where the straight line of
/// high rates meets the axis; infinite_viscosity, Pa s, > 0; characteristic_rate, 1/s, > 0: where
/// 63 % of the structure that shear breaks is broken. Limits: extrapolated_stress = yield_stress is
/// Bingham.
template <class Scalar = double>
struct WindhabLaw {
    static constexpr std::string_view name = "windhab";
    static constexpr std::array parameters{
        ParameterName{"yield_stress", "Pa"}, ParameterName{"extrapolated_stress", "Pa"},
        ParameterName{"infinite_viscosity", "Pa.s"}, ParameterName{"characteristic_rate", "1/s"}};

    Scalar yield_stress{};
    Scalar extrapolated_stress{};
    Scalar infinite_viscosity{};
    Scalar characteristic_rate{};

    [[nodiscard]] const Scalar& yield_stress_value() const { return yield_stress; }
    template <class Rate>
    [[nodiscard]] auto excess_stress(const Rate& rate) const {
        using std::expm1;
        return infinite_viscosity * rate -
               (extrapolated_stress - yield_stress) * expm1(-1.0 * (rate / characteristic_rate));
    }
    template <class Rate>
    [[nodiscard]] auto stress(const Rate& rate) const {
        return yield_stress + excess_stress(rate);
    }
    template <class Rate>
    [[nodiscard]] auto stress_slope(const Rate& rate) const {
        using std::exp;
        return infinite_viscosity + (extrapolated_stress - yield_stress) / characteristic_rate *
                                        exp(-1.0 * (rate / characteristic_rate));
    }
    template <class Rate>
    [[nodiscard]] auto log_slope(const Rate& rate) const {
        return stress_slope(rate) * rate / stress(rate);
    }
    [[nodiscard]] double rate_at_excess(double excess) const {
        if (!(excess > 0.0)) {
            return 0.0;
        }
        // The excess is a concave function of the rate, so that Newton's steps from the left rise
        // to the root; the start is the root for the slope at rest, the largest one.
        double rate = excess / stress_slope(0.0);
        for (int iteration = 0; iteration < 200; ++iteration) {
            const double step = (excess - excess_stress(rate)) / stress_slope(rate);
            rate += step;
            if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon() * rate) {
                break;
            }
        }
        return rate;
    }
    [[nodiscard]] double sharpness() const { return 1.0; }
};
using Windhab = WindhabLaw<double>;
static_assert(FlowLaw<Windhab>);

} // namespace searle::laws::flow
