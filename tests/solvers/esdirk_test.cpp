#include "solvers/radial/esdirk.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace searle::solvers::radial {
namespace {

using Vector = std::array<double, Esdirk::stages>;

double dot(const Vector& a, const Vector& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
Vector times(const Vector& a, const Vector& b) {
    Vector product{};
    for (std::size_t k = 0; k < product.size(); ++k) {
        product[k] = a[k] * b[k];
    }
    return product;
}
Vector apply(const Vector& x) {
    Vector result{};
    for (std::size_t k = 0; k < result.size(); ++k) {
        result[k] = dot(Esdirk::weight[k], x);
    }
    return result;
}

// Order conditions: Hairer, Norsett & Wanner, Solving ODEs I, table II.2.1.
TEST(Esdirk, weights_fulfil_all_eight_conditions_of_order_four) {
    const Vector& b = Esdirk::weight[5];
    const Vector& c = Esdirk::time;
    Vector one{};
    one.fill(1.0);
    const double tolerance = 1e-14;
    EXPECT_NEAR(dot(b, one), 1.0, tolerance);
    EXPECT_NEAR(dot(b, c), 1.0 / 2, tolerance);
    EXPECT_NEAR(dot(b, times(c, c)), 1.0 / 3, tolerance);
    EXPECT_NEAR(dot(b, apply(c)), 1.0 / 6, tolerance);
    EXPECT_NEAR(dot(b, times(c, times(c, c))), 1.0 / 4, tolerance);
    EXPECT_NEAR(dot(b, times(c, apply(c))), 1.0 / 8, tolerance);
    EXPECT_NEAR(dot(b, apply(times(c, c))), 1.0 / 12, tolerance);
    EXPECT_NEAR(dot(b, apply(apply(c))), 1.0 / 24, tolerance);
}

TEST(Esdirk, embedded_weights_are_of_order_three_and_not_four) {
    const Vector& b = Esdirk::embedded;
    const Vector& c = Esdirk::time;
    Vector one{};
    one.fill(1.0);
    EXPECT_NEAR(dot(b, one), 1.0, 1e-14);
    EXPECT_NEAR(dot(b, c), 1.0 / 2, 1e-14);
    EXPECT_NEAR(dot(b, times(c, c)), 1.0 / 3, 1e-14);
    EXPECT_NEAR(dot(b, apply(c)), 1.0 / 6, 1e-14);
    EXPECT_GT(std::abs(dot(b, times(c, times(c, c))) - 1.0 / 4), 1e-4);
}

TEST(Esdirk, stages_have_the_stated_times_diagonal_and_order_two) {
    for (std::size_t s = 0; s < Esdirk::stages; ++s) {
        const auto& row = Esdirk::weight[s];
        const double c = Esdirk::time[s];
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), c, 1e-14) << "stage " << s;
        EXPECT_NEAR(dot(row, Esdirk::time), 0.5 * c * c, 1e-14) << "stage " << s;
        EXPECT_EQ(row[s], s == 0 ? 0.0 : Esdirk::diagonal);
    }
}

// L-stability: R(z) -> 0 as z -> -infinity, since the last stage is the step's end and the explicit
// first stage's weight drops out. R(z) = 1 + z b^T (I - z A)^-1 1, by forward substitution.
TEST(Esdirk, is_stable_on_the_negative_axis_and_damps_stiff_modes) {
    for (double z = -1e-3; z > -1e9; z *= 3.0) {
        Vector stage{};
        for (std::size_t s = 0; s < Esdirk::stages; ++s) {
            double sum = 1.0;
            for (std::size_t j = 0; j < s; ++j) {
                sum += z * Esdirk::weight[s][j] * stage[j];
            }
            stage[s] = sum / (1.0 - z * Esdirk::weight[s][s]);
        }
        EXPECT_LE(std::abs(stage[5]), 1.0) << "z = " << z;
        if (z < -1e8) {
            EXPECT_LT(std::abs(stage[5]), 1e-6);
        }
    }
}

} // namespace
} // namespace searle::solvers::radial
