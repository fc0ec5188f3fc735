#include "rheometry/correction/local_slope.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <stdexcept>

namespace searle::rheometry {
namespace {

std::vector<double> evenly_spaced(double from, double to, int count) {
    std::vector<double> x;
    for (int i = 0; i < count; ++i)
        x.push_back(from + (to - from) * i / (count - 1));
    return x;
}

TEST(correction_local_slope, a_cubic_is_differentiated_exactly) {
    const std::vector<double> x = evenly_spaced(-2.0, 3.0, 17);
    std::vector<double> y;
    for (const double at : x)
        y.push_back(1.0 - 2.0 * at + 0.5 * at * at + 0.25 * at * at * at);
    const auto slopes = local_slopes(x, y, std::vector<double>(x.size(), 1.0));
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(slopes[i].value, y[i], 1e-10);
        EXPECT_NEAR(slopes[i].slope, -2.0 + x[i] + 0.75 * x[i] * x[i], 1e-9);
        EXPECT_NEAR(slopes[i].curvature, 1.0 + 1.5 * x[i], 1e-8);
    }
}

// A local cubic's slope errs with the third power of the spacing at the ends and the fourth inside
// (textbook order of local polynomials), so that the largest error falls eightfold or more.
TEST(correction_local_slope, error_falls_third_order_up_to_the_ends) {
    std::vector<double> errors;
    for (const int count : {20, 40, 80}) {
        const std::vector<double> x = evenly_spaced(0.0, 6.0, count);
        std::vector<double> y;
        for (const double at : x)
            y.push_back(std::sin(at));
        const auto slopes = local_slopes(x, y, std::vector<double>(x.size(), 1.0));
        double largest = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
            largest = std::max(largest, std::abs(slopes[i].slope - std::cos(x[i])));
        errors.push_back(largest);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 2.6) << errors[0] << " " << errors[1];
    EXPECT_GT(std::log2(errors[1] / errors[2]), 2.6) << errors[1] << " " << errors[2];
    EXPECT_LT(errors[2], 3e-4);
}

// A normal variable is within one standard error with a chance of 0.68, within two with 0.95. The
// interval is chosen by the data too, so a few percent more or fewer are allowed for.
TEST(correction_local_slope, standard_error_covers_the_scatter) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> scatter(0.0, 0.01);
    const std::vector<double> x = evenly_spaced(0.0, 7.0, 40);
    const std::vector<double> ones(x.size(), 1.0);
    double within_one = 0.0;
    double within_two = 0.0;
    double all = 0.0;
    for (int repeat = 0; repeat < 300; ++repeat) {
        std::vector<double> y;
        for (const double at : x)
            y.push_back(0.4 * at + 0.3 * std::tanh(at - 3.5) + scatter(random));
        const auto slopes = local_slopes(x, y, ones);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double exact = 0.4 + 0.3 / std::pow(std::cosh(x[i] - 3.5), 2.0);
            const double z = (slopes[i].slope - exact) / slopes[i].slope_standard_error;
            within_one += std::abs(z) < 1.0 ? 1.0 : 0.0;
            within_two += std::abs(z) < 2.0 ? 1.0 : 0.0;
            all += 1.0;
        }
    }
    EXPECT_GT(within_one / all, 0.62);
    EXPECT_LT(within_one / all, 0.90);
    EXPECT_GT(within_two / all, 0.90);
}

// Without curvature the widest window is right: its standard error is that of a straight line's
// slope times what a cubic costs, far below that of five points.
TEST(correction_local_slope, windows_grow_where_the_curve_is_straight) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> scatter(0.0, 0.01);
    const std::vector<double> x = evenly_spaced(0.0, 1.0, 41);
    std::vector<double> y;
    for (const double at : x)
        y.push_back(at + scatter(random));
    const auto slopes = local_slopes(x, y, std::vector<double>(x.size(), 1.0));
    EXPECT_GE(slopes[20].window, 25U);
    EXPECT_NEAR(slopes[20].slope, 1.0, 3.0 * slopes[20].slope_standard_error);
    EXPECT_LT(slopes[20].slope_standard_error, 0.05);
}

TEST(correction_local_slope, too_few_points_are_refused) {
    const std::vector<double> four{1.0, 2.0, 3.0, 4.0};
    EXPECT_THROW((void)local_slopes(four, four, four), std::invalid_argument);
}

} // namespace
} // namespace searle::rheometry
