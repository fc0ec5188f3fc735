#include "solvers/radial/gauss_rule.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace searle::solvers::radial {
namespace {

template <int Points>
GaussRule<Points> make_rule() {
    GaussRule<Points> rule{};
    const auto zeros = boost::math::legendre_p_zeros<double>(Points); // the non-negative ones
    const int count = static_cast<int>(zeros.size());
    for (int k = 0; k < count; ++k) {
        const double zero = zeros[static_cast<std::size_t>(k)];
        const double slope = boost::math::legendre_p_prime(Points, zero);
        const double weight = 2.0 / ((1.0 - zero * zero) * slope * slope);
        const auto upper = static_cast<std::size_t>(Points - count + k);
        const auto lower = static_cast<std::size_t>(count - 1 - k);
        rule.node[upper] = zero;
        rule.weight[upper] = weight;
        rule.node[lower] = zero == 0.0 ? 0.0 : -zero;
        rule.weight[lower] = weight;
    }
    return rule;
}

} // namespace

template <int Points>
const GaussRule<Points>& gauss_rule() {
    static const GaussRule<Points> rule = make_rule<Points>();
    return rule;
}

template const GaussRule<5>& gauss_rule<5>();
template const GaussRule<8>& gauss_rule<8>();
template const GaussRule<12>& gauss_rule<12>();

} // namespace searle::solvers::radial
