#include "rheometry/fit/ramp_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

namespace fit = searle::rheometry::fit;

/// Rates 1 to 9 in `steps` steps, and back.
std::vector<double> up_and_down(int steps) {
    std::vector<double> rates;
    for (int k = 0; k <= steps; ++k)
        rates.push_back(1.0 + 8.0 * k / steps);
    for (int k = steps - 1; k >= 0; --k)
        rates.push_back(1.0 + 8.0 * k / steps);
    return rates;
}

// Up 2 x + 1, down x: the area between is that of x + 1 over 1 ... 9, 40 + 8.
TEST(RampLoop, area_between_straight_ways_is_exact) {
    const std::vector<double> rates = up_and_down(10);
    std::vector<double> stresses;
    std::vector<double> inertial;
    for (std::size_t k = 0; k < rates.size(); ++k) {
        stresses.push_back(k <= 10 ? 2.0 * rates[k] + 1.0 : rates[k]);
        inertial.push_back(k <= 10 ? 0.5 : -0.5);
    }
    // The fastest row belongs to both ways: the last piece down starts on the way up, and adds
    // half of a step's width times what the ways differ by there, 10 / 2 * 0.8 = 4.
    const auto loop = fit::ramp_loop(rates, stresses, inertial);
    ASSERT_TRUE(loop);
    EXPECT_EQ(loop->turning_row, 10U);
    EXPECT_NEAR(loop->measured, 48.0 - 4.0, 1e-12);
    EXPECT_NEAR(loop->inertial, 8.0 - 0.4, 1e-12);
    EXPECT_NEAR(loop->rest(), 44.0 - 7.6, 1e-12);
    EXPECT_DOUBLE_EQ(loop->low_rate, 1.0);
    EXPECT_DOUBLE_EQ(loop->high_rate, 9.0);
}

// Spread of the area over 400 noisy copies against the mean of the claimed standard errors; the
// spread itself is known to 1/sqrt(800) = 3.5 %, the ends of the ways have no neighbours: 15 %.
TEST(RampLoop, standard_error_is_the_spread_of_the_area) {
    const std::vector<double> rates = up_and_down(40);
    const std::vector<double> none(rates.size());
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    double sum = 0.0;
    double square = 0.0;
    double claimed = 0.0;
    constexpr int copies = 400;
    for (int copy = 0; copy < copies; ++copy) {
        std::vector<double> stresses;
        for (const double rate : rates)
            stresses.push_back((3.0 + 2.0 * std::sqrt(rate)) * (1.0 + 0.01 * normal(engine)));
        const auto loop = fit::ramp_loop(rates, stresses, none);
        ASSERT_TRUE(loop);
        sum += loop->measured / copies;
        square += loop->measured * loop->measured / copies;
        claimed += loop->standard_error / copies;
    }
    const double spread = std::sqrt(square - sum * sum);
    EXPECT_NEAR(claimed / spread, 1.0, 0.15);
    EXPECT_LT(std::abs(sum), 4.0 * spread / std::sqrt(double(copies)));
}

TEST(RampLoop, one_way_or_few_rows_are_no_loop) {
    std::vector<double> rates;
    for (int k = 1; k <= 20; ++k)
        rates.push_back(k);
    const std::vector<double> none(20);
    EXPECT_FALSE(fit::ramp_loop(rates, rates, none));
    const std::vector<double> few{1, 2, 3, 2, 1};
    EXPECT_FALSE(fit::ramp_loop(few, few, std::vector<double>(5)));
    std::vector<double> zigzag;
    for (int k = 0; k < 20; ++k)
        zigzag.push_back(k % 2 == 0 ? 1.0 + k : 30.0 - k);
    EXPECT_FALSE(fit::ramp_loop(zigzag, zigzag, none));
}

// Down first and up again is a loop too, with the same sign: positive when the way up lies above.
TEST(RampLoop, order_of_the_ways_does_not_matter) {
    const std::vector<double> up = up_and_down(10);
    std::vector<double> rates(up.begin() + 10, up.end());
    rates.insert(rates.end(), up.begin() + 1, up.begin() + 11);
    std::vector<double> stresses;
    for (std::size_t k = 0; k < rates.size(); ++k)
        stresses.push_back(k <= 10 ? rates[k] : rates[k] + 1.0);
    const auto loop = fit::ramp_loop(rates, stresses, std::vector<double>(rates.size()));
    ASSERT_TRUE(loop);
    EXPECT_NEAR(loop->measured, 8.0 - 0.4, 1e-12);
}

} // namespace
