#include "solvers/radial/tabulated_inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace searle::solvers::radial {
namespace {

template <class Law>
void expect_rates_of(const Law& law, double typical_rate) {
    const double typical = law.stress(typical_rate);
    const TabulatedLaw<Law> tabulated(law, typical);
    double worst = 0.0;
    for (double stress = 1e-12 * typical; stress < 1e8 * typical; stress *= 1.0137) {
        worst = std::max(
            worst, std::abs(tabulated.rate_at_excess(stress) / law.rate_at_excess(stress) - 1.0));
    }
    EXPECT_LT(worst, 1e-11) << law.name;
    EXPECT_EQ(tabulated.rate_at_excess(0.0), 0.0);
}

TEST(TabulatedInverse, gives_the_law_s_own_rate_to_1e_minus_11) {
    for (const double transition : {0.5, 2.0, 6.0}) {
        for (const double index : {0.1, 0.5, 0.9}) {
            expect_rates_of(laws::flow::CarreauYasuda{3.0, 0.0, 2.0, index, transition}, 10.0);
            expect_rates_of(laws::flow::CarreauYasuda{3.0, 3e-4, 200.0, index, transition}, 10.0);
        }
    }
    for (const double index : {0.05, 0.5, 0.95}) {
        expect_rates_of(laws::flow::Cross{3.0, 0.0, 2.0, index}, 10.0);
        expect_rates_of(laws::flow::Cross{3.0, 3e-4, 0.01, index}, 10.0);
    }
}

} // namespace
} // namespace searle::solvers::radial
