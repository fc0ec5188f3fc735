#pragma once

#include <array>

namespace searle::solvers::radial {

/// Gauss–Legendre rules on [-1, 1]; nodes increasing. Computed to double precision from the roots
/// of the Legendre polynomials (checked by tests/solvers/gauss_rule_test.cpp on all monomials).
template <int Points>
struct GaussRule {
    std::array<double, Points> node;
    std::array<double, Points> weight;
};

/// The rule with the given number of points, made at first use.
template <int Points>
[[nodiscard]] const GaussRule<Points>& gauss_rule();

extern template const GaussRule<5>& gauss_rule<5>();
extern template const GaussRule<8>& gauss_rule<8>();
extern template const GaussRule<12>& gauss_rule<12>();

} // namespace searle::solvers::radial
