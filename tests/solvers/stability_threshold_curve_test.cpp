#include "solvers/stability/taylor_threshold.hpp"
#include "solvers/stability/threshold_curve.hpp"

#include <gtest/gtest.h>

namespace searle::solvers::stability {
namespace {

// Origin: the eigenvalue problem itself, at gaps that are no nodes of the interpolation.
TEST(ThresholdCurve, agrees_with_the_eigenvalue_problem_for_every_narrower_gap) {
    for (const double widest : {1e-3, 0.0714, 0.1, 0.3, 0.6, 1.0, 19.0}) {
        const ThresholdCurve curve(widest);
        for (double share = 1.0; share > 1e-7; share *= 0.37) {
            const double relative_gap = widest * share;
            EXPECT_NEAR(curve.critical_reynolds(relative_gap) /
                            taylor_threshold(relative_gap).reynolds,
                        1.0, 1e-6)
                << relative_gap << " of " << widest;
        }
    }
}

} // namespace
} // namespace searle::solvers::stability
