#include "solvers/suspension/block_statistics.hpp"

#include "solvers/particles/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers::suspension {
namespace {

/// First-order autoregression with correlation c, variance 1: the mean of n values has the variance
/// (1 + c) / (1 - c) / n for n (1 - c) >> 1.
std::vector<double> correlated(std::size_t count, double c, std::uint64_t key) {
    std::vector<double> series(count);
    double value = particles::normal(key, 0);
    for (std::size_t k = 0; k < count; ++k) {
        value = c * value + std::sqrt(1.0 - c * c) * particles::normal(key, k + 1);
        series[k] = value;
    }
    return series;
}

TEST(BlockStatistics, standard_error_covers_the_scatter_of_correlated_means) {
    const double c = 0.9;
    const std::size_t count = 4000;
    const double expected = std::sqrt((1.0 + c) / (1.0 - c) / static_cast<double>(count));
    double squared = 0.0;
    double claimed = 0.0;
    const int repeats = 200;
    for (int r = 0; r < repeats; ++r) {
        const SeriesMean mean =
            mean_of_series(correlated(count, c, static_cast<std::uint64_t>(r) + 1));
        squared += mean.mean * mean.mean;
        claimed += mean.standard_error;
    }
    // The scatter itself is as derived (two hundred samples: 5 % per standard error).
    EXPECT_NEAR(std::sqrt(squared / repeats) / expected, 1.0, 0.2);
    // Taking the largest of the levels errs towards larger errors, by less than a half.
    EXPECT_GT(claimed / repeats, 0.95 * expected);
    EXPECT_LT(claimed / repeats, 1.5 * expected);
}

TEST(BlockStatistics, finds_the_end_of_the_start_up) {
    std::vector<double> series = correlated(1000, 0.3, 7);
    for (std::size_t k = 0; k < series.size(); ++k)
        series[k] = 100.0 + series[k] + 50.0 * std::exp(-static_cast<double>(k) / 30.0);
    const std::size_t start = start_up_length(series);
    // 50 exp(-k/30) is below the scatter of 1 from k = 117 on.
    EXPECT_GE(start, 90U);
    EXPECT_LE(start, 220U);
    EXPECT_LE(start_up_length(correlated(1000, 0.3, 8)), 500U);
}

TEST(BlockStatistics, line_meets_what_grows_linearly) {
    std::vector<double> x, y;
    for (int k = 0; k < 40; ++k) {
        x.push_back(0.1 * k);
        y.push_back(3.0 + 2.0 * x.back());
    }
    EXPECT_NEAR(line_at(x, y, 5.0).value, 13.0, 1e-12);
    EXPECT_NEAR(line_at(x, y, 5.0).standard_error, 0.0, 1e-12);
}

TEST(BlockStatistics, few_values_have_no_error_to_tell) {
    EXPECT_TRUE(std::isinf(mean_of_series(std::vector<double>{1.0, 2.0}).standard_error));
}

} // namespace
} // namespace searle::solvers::suspension
