#pragma once

#include "laws/flow/law_concept.hpp"

#include <cmath>
#include <limits>

namespace searle::laws::flow {

/// viscosity = zero_viscosity / [1 + (stress / half_stress)^(exponent - 1)]. Ellis, in Reiner 1960,
/// Deformation, Strain and Flow, 246; Bird, Armstrong & Hassager 1987, table 4.5-1.
/// zero_viscosity, Pa s, > 0; half_stress, Pa, > 0: the stress at which the viscosity has fallen to
/// half; exponent (alpha), 1, >= 1: 1/alpha is the log-log slope of stress against rate far above
/// half_stress.
/// Limits: zero_viscosity as rate -> 0. The law gives the rate for a stress, so that the stress for
/// a rate is the root of one equation (a few Newton steps, relative error of rounding's size).
template <class Scalar = double>
struct EllisLaw {
    static constexpr std::string_view name = "ellis";
    static constexpr std::array parameters{ParameterName{"zero_viscosity", "Pa.s"},
                                           ParameterName{"half_stress", "Pa"},
                                           ParameterName{"exponent", "1"}};

    Scalar zero_viscosity{};
    Scalar half_stress{};
    Scalar exponent{};

    [[nodiscard]] double yield_stress_value() const { return 0.0; }
    template <class Stress>
    [[nodiscard]] auto rate_at_excess(const Stress& excess) const {
        using std::pow;
        return excess / zero_viscosity * (1.0 + pow(excess / half_stress, exponent - 1.0));
    }
    [[nodiscard]] Scalar excess_stress(double rate) const {
        if (!(rate > 0.0)) {
            return zero_viscosity * rate;
        }
        // Newton in ln(stress) on ln(rate): convex, with a slope between 1 and alpha.
        const double viscosity = plain(zero_viscosity);
        const double half = plain(half_stress);
        const double alpha = plain(exponent);
        const double target = std::log(rate) + std::log(viscosity);
        // From above: the smaller of the two stresses that one term alone would need.
        double log_stress = std::min(target, std::log(half) + (target - std::log(half)) / alpha);
        double slope = 1.0;
        for (int iteration = 0; iteration < 60; ++iteration) {
            const double power = std::exp((alpha - 1.0) * (log_stress - std::log(half)));
            slope = 1.0 + (alpha - 1.0) * power / (1.0 + power);
            const double step = (target - log_stress - std::log1p(power)) / slope;
            log_stress += step;
            if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon() *
                                      std::max(1.0, std::abs(log_stress))) {
                break;
            }
        }
        // One further step in the scalar's own arithmetic carries the derivatives over.
        const double stress = std::exp(log_stress);
        return stress * (1.0 + (rate / rate_at_excess(stress) - 1.0) / slope);
    }
    [[nodiscard]] Scalar stress(double rate) const { return excess_stress(rate); }
    [[nodiscard]] auto stress_slope(double rate) const {
        return excess_stress(rate) / rate * log_slope(rate);
    }
    [[nodiscard]] auto log_slope(double rate) const {
        using std::pow;
        const auto power = pow(excess_stress(rate) / half_stress, exponent - 1.0);
        return 1.0 / (1.0 + (exponent - 1.0) * (1.0 / (1.0 + 1.0 / power)));
    }
    [[nodiscard]] double sharpness() const { return 1.0; }

private:
    static double plain(double value) { return value; }
    /// The value of a number that carries derivatives.
    template <class Number>
    requires requires(const Number& number) { number.a; }
    static double plain(const Number& value) { return value.a; }
};
using Ellis = EllisLaw<double>;
static_assert(FlowLaw<Ellis>);

} // namespace searle::laws::flow
