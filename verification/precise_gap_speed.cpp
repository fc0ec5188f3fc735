#include "verification/precise_gap_speed.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace searle::verification {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

Real quadrature(const auto& integrand, const Real& low, const Real& high) {
    static boost::math::quadrature::tanh_sinh<Real> rule(9);
    if (!(low < high)) {
        return Real(0);
    }
    // Over [-1, 1]: the rule's nodes crowd at the ends, closer than low or high can resolve.
    const Real half = (high - low) / 2;
    return half * rule.integrate(
                      [&](const Real& x, const Real& to_end) -> Real {
                          return integrand(x < 0 ? low - half * to_end : high - half * to_end);
                      },
                      Real(1e-24));
}

/// d omega / d ln(tau) = (rate_inner - rate_outer) / 2 turns an error of omega into one of the
/// stress. For laws whose rate is explicit: over e = stress - yield, d ln(stress) = de / (yield +
/// e).
template <class Precise>
Real error_over_stress(const Precise& law, const Real& shrink, const Real& omega,
                       const Real& stress) {
    const Real yield = law.yield_stress_value();
    const Real excess = stress - yield;
    const Real outer_excess = (excess - yield * shrink) / (1 + shrink);
    const Real low = outer_excess > 0 ? outer_excess : Real(0);
    const Real speed =
        quadrature([&](const Real& e) -> Real { return law.rate_at_excess(e) / (yield + e); }, low,
                   excess) /
        2;
    const Real outer_rate = low > 0 ? Real(law.rate_at_excess(low)) : Real(0);
    return (speed - omega) / ((Real(law.rate_at_excess(excess)) - outer_rate) / 2);
}

/// For laws whose rate is not: over ln(rate), after inverting the law with 50 digits.
template <class Precise>
Real error_over_rate(const Precise& law, double start_inner, double start_outer, const Real& shrink,
                     const Real& omega, const Real& stress) {
    const auto invert = [&](const Real& target, double start) {
        Real log_rate = log(Real(start));
        for (int k = 0; k < 60; ++k) {
            const Real rate = exp(log_rate);
            const Real step = log(Real(law.stress(rate)) / target) / Real(law.log_slope(rate));
            log_rate -= step;
            if (abs(step) < Real(1e-40)) {
                break;
            }
        }
        return log_rate;
    };
    const Real inner = invert(stress, start_inner);
    const Real outer = invert(stress / (1 + shrink), start_outer);
    const Real speed = quadrature(
                           [&](const Real& s) -> Real {
                               const Real rate = exp(s);
                               return rate * law.log_slope(rate);
                           },
                           outer, inner) /
                       2;
    return (speed - omega) / ((exp(inner) - exp(outer)) / 2);
}

struct Judge {
    double shrink, omega, stress;

    double operator()(const laws::flow::Newtonian& law) const {
        return over_stress(laws::flow::NewtonianLaw<Real>{law.viscosity});
    }
    double operator()(const laws::flow::Bingham& law) const {
        return over_stress(laws::flow::BinghamLaw<Real>{law.yield_stress, law.plastic_viscosity});
    }
    double operator()(const laws::flow::PowerLaw& law) const {
        return over_stress(laws::flow::PowerLawLaw<Real>{law.consistency, law.flow_index});
    }
    double operator()(const laws::flow::HerschelBulkley& law) const {
        return over_stress(laws::flow::HerschelBulkleyLaw<Real>{law.yield_stress, law.consistency,
                                                                law.flow_index});
    }
    double operator()(const laws::flow::Casson& law) const {
        return over_stress(laws::flow::CassonLaw<Real>{law.yield_stress, law.plastic_viscosity});
    }
    double operator()(const laws::flow::CarreauYasuda& law) const {
        return over_rate(law, laws::flow::CarreauYasudaLaw<Real>{
                                  law.zero_viscosity, law.infinite_viscosity, law.time_constant,
                                  law.flow_index, law.transition});
    }
    double operator()(const laws::flow::Cross& law) const {
        return over_rate(law, laws::flow::CrossLaw<Real>{law.zero_viscosity, law.infinite_viscosity,
                                                         law.time_constant, law.flow_index});
    }
    double over_stress(const auto& precise) const {
        return static_cast<double>(error_over_stress(precise, shrink, omega, stress));
    }
    double over_rate(const auto& law, const auto& precise) const {
        const double outer = stress / (1.0 + shrink);
        return static_cast<double>(error_over_rate(
            precise, law.rate_at_excess(stress), law.rate_at_excess(outer), shrink, omega, stress));
    }
};

} // namespace

double steady_stress_error(const laws::flow::AnyFlowLaw& law, double delta_squared_minus_one,
                           double omega, double stress) {
    return std::visit(Judge{delta_squared_minus_one, omega, stress}, law);
}

} // namespace searle::verification
