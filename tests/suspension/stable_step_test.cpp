#include "solvers/suspension/stable_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::suspension {
namespace {

/// Largest of the last places over the first ones of a particle on a spring, step by step.
double growth(double step, double stiffness, double mass, double drag) {
    const double tau = mass / drag;
    const double kept = std::exp(-step / tau);
    double x = 1.0;
    double v = 0.0;
    double largest = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double force = -stiffness * x;
        x += tau * (1.0 - kept) * v + (step - tau * (1.0 - kept)) * force / drag;
        v = kept * v + (1.0 - kept) * force / drag;
        if (!std::isfinite(x))
            return std::numeric_limits<double>::infinity();
        if (i >= 3900)
            largest = std::max(largest, std::abs(x));
    }
    return largest;
}

// Stepping itself tells, from no mass to little drag.
TEST(StableStep, is_where_a_particle_on_a_spring_begins_to_swing_up) {
    for (const double mass : {1e-4, 0.1, 0.5, 1.0, 2.0, 10.0, 1e3}) {
        const double limit = longest_stable_step(1.0, mass, 1.0);
        EXPECT_LT(growth(0.95 * limit, 1.0, mass, 1.0), 1.0) << mass;
        EXPECT_GT(growth(1.05 * limit, 1.0, mass, 1.0), 1.1) << mass;
    }
    EXPECT_NEAR(longest_stable_step(3.0, 1e-9, 2.0), 2.0 * 2.0 / 3.0, 1e-6); // without mass
}

} // namespace
} // namespace searle::solvers::suspension
