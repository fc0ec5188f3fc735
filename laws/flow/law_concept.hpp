#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string_view>

namespace searle::laws::flow {

/// One parameter of a flow law, in the order of the law's members.
struct ParameterName {
    std::string_view key;  ///< name in case files and in fit results
    std::string_view unit; ///< SI unit; "Pa.s^n" where it depends on the flow index
};

/// What a flow law (simple shear, shear rate >= 0, SI units) offers.
///
/// Every law is a template on the scalar of its parameters, so that one text serves the solvers
/// (double) and anything that differentiates with respect to a parameter. A law must fulfil:
///  - stress(0) = yield_stress() >= 0, and stress(rate) strictly increasing;
///  - stress(rate) = yield_stress() + excess_stress(rate), the excess free of cancellation;
///  - rate_at_excess is the inverse of excess_stress, and 0 at 0;
///  - stress_slope is d stress / d rate, for rate > 0;
///  - log_slope is d ln stress / d ln rate, for rate > 0, bounded, and free of overflow.
template <class Law>
concept FlowLaw = requires(const Law& law, double rate) {
    { Law::name } -> std::convertible_to<std::string_view>;
    { Law::parameters.size() } -> std::convertible_to<std::size_t>;
    { law.yield_stress_value() } -> std::convertible_to<double>;
    { law.stress(rate) } -> std::convertible_to<double>;
    { law.excess_stress(rate) } -> std::convertible_to<double>;
    { law.rate_at_excess(rate) } -> std::convertible_to<double>;
    { law.stress_slope(rate) } -> std::convertible_to<double>;
    { law.log_slope(rate) } -> std::convertible_to<double>;
    { law.sharpness() } -> std::convertible_to<double>;
};

} // namespace searle::laws::flow
