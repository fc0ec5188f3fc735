#include "solvers/radial/gauss_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace searle::solvers::radial {
namespace {

template <int Points>
void expect_exact_on_monomials() {
    const auto& rule = gauss_rule<Points>();
    for (int power = 0; power < 2 * Points; ++power) {
        double sum = 0.0;
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            sum += rule.weight[k] * std::pow(rule.node[k], power);
        }
        // integral of x^power over [-1, 1].
        const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
        EXPECT_NEAR(sum, exact, 4e-15) << Points << " points, power " << power;
    }
    double beyond = 0.0;
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
        beyond += rule.weight[k] * std::pow(rule.node[k], 2 * Points);
    }
    EXPECT_GT(std::abs(beyond - 2.0 / (2 * Points + 1)), 1e-9) << "no rule is exact beyond 2n - 1";
}

TEST(GaussRule, integrates_every_monomial_up_to_degree_2n_minus_1) {
    expect_exact_on_monomials<5>();
    expect_exact_on_monomials<8>();
    expect_exact_on_monomials<12>();
}

} // namespace
} // namespace searle::solvers::radial
