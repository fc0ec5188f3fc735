#include "solvers/suspension/correlated_series.hpp"

#include "solvers/particles/random_numbers.hpp"
#include "solvers/suspension/start_up.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace searle::solvers::suspension {
namespace {

/// First-order autoregression with correlation c, mean 0 and variance 1, stationary.
std::vector<double> correlated(std::size_t count, double c, std::uint64_t key) {
    std::vector<double> series(count);
    double value = particles::normal(key, 0);
    for (std::size_t k = 0; k < count; ++k) {
        value = c * value + std::sqrt(1.0 - c * c) * particles::normal(key, k + 1);
        series[k] = value;
    }
    return series;
}

/// Standard deviation of the mean of it, exact: the sum of (n - |k|) c^|k| / n^2.
double deviation_of_mean(std::size_t count, double c) {
    const auto n = static_cast<double>(count);
    return std::sqrt(
        ((1.0 + c) / (1.0 - c) - 2.0 * c * (1.0 - std::pow(c, n)) / (n * (1.0 - c) * (1.0 - c))) /
        n);
}

/// How the errors of many series fare.
struct Coverage {
    double within_one{};  ///< share of the truths within one error
    double within_two{};  ///< within two
    double size{};        ///< mean error over the true deviation
    double scatter{};     ///< of the values, over the true deviation
    double independent{}; ///< mean
};

template <class Estimate>
Coverage coverage(int repeats, double deviation, double truth, Estimate estimate) {
    Coverage result;
    double squares = 0.0;
    for (int r = 0; r < repeats; ++r) {
        const SeriesEstimate found = estimate(static_cast<std::uint64_t>(r) + 1);
        const double off = std::abs(found.value - truth);
        result.within_one += (off <= found.error) / static_cast<double>(repeats);
        result.within_two += (off <= 2.0 * found.error) / static_cast<double>(repeats);
        result.size += found.error / deviation / repeats;
        result.independent += found.independent / repeats;
        squares += off * off / repeats;
    }
    result.scatter = std::sqrt(squares) / deviation;
    return result;
}

constexpr int repeats = 250;
/// A share of 0.95 found in 250 trials has a standard error of 1.4 %, one of 0.68 of 3 %.
constexpr double three_errors_of_two = 0.042;
constexpr double three_errors_of_one = 0.09;

TEST(CorrelatedSeries, errors_hold_the_truth_down_to_four_correlation_times) {
    // 200 values of AR(1): the truth and the deviation of the mean are exact.
    for (const double times : {4.0, 8.0, 30.0, 100.0}) {
        const double c = std::exp(-times / 200.0);
        const double deviation = deviation_of_mean(200, c);
        const Coverage found = coverage(repeats, deviation, 0.0, [&](std::uint64_t key) {
            return mean_of_series(correlated(200, c, key));
        });
        EXPECT_NEAR(found.scatter, 1.0, 0.15) << times; // three errors of a deviation from 250
        EXPECT_GT(found.within_one, 0.683 - three_errors_of_one) << times;
        EXPECT_GT(found.within_two, 0.954 - three_errors_of_two) << times;
        // And are not so wide that they say nothing.
        EXPECT_LT(found.size, 2.2) << times;
        EXPECT_GT(found.size, 1.0) << times;
    }
}

TEST(CorrelatedSeries, of_two_correlation_times_most_errors_hold) {
    // Nothing in such a series tells that it is not slower still: 85 % is what is left of 95 %.
    const double c = std::exp(-2.0 / 200.0);
    const Coverage found =
        coverage(repeats, deviation_of_mean(200, c), 0.0,
                 [&](std::uint64_t key) { return mean_of_series(correlated(200, c, key)); });
    EXPECT_GT(found.within_two, 0.85);
    EXPECT_LT(found.independent, enough_independent);
}

TEST(CorrelatedSeries, a_line_through_correlated_values_has_its_error_too) {
    // The end of a line through 24 values, as of a ramp's last row; the exact deviation from the
    // covariance of AR(1) with the weights of least squares.
    std::vector<double> x(24);
    for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = static_cast<double>(k);
    const double c = std::exp(-12.0 / 24.0);
    double variance = 0.0;
    std::vector<double> weights(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        std::vector<double> unit(x.size(), 0.0);
        unit[k] = 1.0;
        weights[k] = value_on_line(x, unit, 23.0);
    }
    for (std::size_t k = 0; k < x.size(); ++k)
        for (std::size_t m = 0; m < x.size(); ++m)
            variance += weights[k] * weights[m] * std::pow(c, std::abs(x[k] - x[m]));
    const Coverage found =
        coverage(repeats, std::sqrt(variance), 7.0 + 0.5 * 23.0, [&](std::uint64_t key) {
            std::vector<double> values = correlated(x.size(), c, key);
            for (std::size_t k = 0; k < x.size(); ++k)
                values[k] += 7.0 + 0.5 * x[k];
            return line_at(x, values, 23.0);
        });
    EXPECT_NEAR(found.scatter, 1.0, 0.15);
    EXPECT_GT(found.within_one, 0.683 - three_errors_of_one);
    EXPECT_GT(found.within_two, 0.954 - three_errors_of_two);
    EXPECT_LT(found.size, 2.2);
}

TEST(CorrelatedSeries, a_smooth_slow_series_is_not_taken_for_a_certain_one) {
    // Half a swing of a cosine of amplitude 1, without any noise. Eight blocks taken as independent
    // would give 0.25, thirty-two 0.12.
    std::vector<double> series(200);
    for (std::size_t k = 0; k < series.size(); ++k)
        series[k] = std::cos(3.14159 * static_cast<double>(k) / 200.0);
    EXPECT_GT(mean_of_series(series).error, 0.3);
}

TEST(CorrelatedSeries, independent_values_count_as_such) {
    const Coverage found = coverage(repeats, 1.0 / std::sqrt(200.0), 0.0, [&](std::uint64_t key) {
        return mean_of_series(correlated(200, 0.0, key));
    });
    EXPECT_GT(found.within_two, 0.954 - three_errors_of_two);
    EXPECT_LT(found.size, 1.7);
    EXPECT_GT(found.independent, 3.0 * enough_independent);
}

TEST(CorrelatedSeries, few_values_have_no_error_and_equal_ones_no_scatter) {
    EXPECT_TRUE(std::isinf(mean_of_series(std::vector<double>{1.0, 2.0}).error));
    const SeriesEstimate equal = mean_of_series(std::vector<double>(100, 0.1));
    EXPECT_NEAR(equal.value, 0.1, 1e-15);
    EXPECT_EQ(equal.error, 0.0);
    std::vector<double> x, y;
    for (int k = 0; k < 40; ++k) {
        x.push_back(0.1 * k);
        y.push_back(3.0 + 2.0 * x.back());
    }
    EXPECT_NEAR(line_at(x, y, 5.0).value, 13.0, 1e-12);
    EXPECT_NEAR(line_at(x, y, 5.0).error, 0.0, 1e-12);
}

TEST(StartUp, its_end_is_found) {
    std::vector<double> series = correlated(1000, 0.3, 7);
    for (std::size_t k = 0; k < series.size(); ++k)
        series[k] = 100.0 + series[k] + 50.0 * std::exp(-static_cast<double>(k) / 30.0);
    const std::size_t start = start_up_length(series);
    // 50 exp(-k/30) is below the scatter of 1 from k = 117 on.
    EXPECT_GE(start, 90U);
    EXPECT_LE(start, 220U);
    EXPECT_LE(start_up_length(correlated(1000, 0.3, 8)), 500U);
}

} // namespace
} // namespace searle::solvers::suspension
