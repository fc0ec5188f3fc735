#include "rheometry/fit/statistics.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::rheometry::fit {
namespace {

double log_choose(std::size_t from, std::size_t take) {
    return std::lgamma(double(from) + 1.0) - std::lgamma(double(take) + 1.0) -
           std::lgamma(double(from - take) + 1.0);
}

/// Ways to split `items` into `parts` non-empty stretches, logarithm; -infinity for none.
double log_splits(std::size_t items, std::size_t parts) {
    if (parts == 0 || parts > items)
        return -std::numeric_limits<double>::infinity();
    return log_choose(items - 1, parts - 1);
}

} // namespace

double student_t95(std::size_t degrees_of_freedom) {
    if (degrees_of_freedom == 0)
        return std::numeric_limits<double>::infinity();
    return boost::math::quantile(
        boost::math::students_t_distribution<double>(static_cast<double>(degrees_of_freedom)),
        0.975);
}

std::optional<RunsTest> runs_test(std::span<const double> residuals) {
    std::size_t positive = 0;
    RunsTest test;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        const bool up = residuals[k] >= 0.0;
        positive += up ? 1 : 0;
        if (k == 0 || up != (residuals[k - 1] >= 0.0))
            ++test.runs;
    }
    const std::size_t negative = residuals.size() - positive;
    if (residuals.size() < 6 || positive == 0 || negative == 0)
        return std::nullopt;
    test.expected_runs = 1.0 + 2.0 * double(positive) * double(negative) / double(residuals.size());
    const double all = log_choose(residuals.size(), positive);
    for (std::size_t runs = 2; runs <= test.runs; ++runs) {
        const std::size_t half = runs / 2;
        if (runs % 2 == 0) {
            test.probability +=
                2.0 * std::exp(log_splits(positive, half) + log_splits(negative, half) - all);
        } else {
            test.probability +=
                std::exp(log_splits(positive, half + 1) + log_splits(negative, half) - all) +
                std::exp(log_splits(positive, half) + log_splits(negative, half + 1) - all);
        }
    }
    test.probability = std::min(1.0, test.probability);
    return test;
}

InformationCriteria information_criteria(double deviance, std::size_t points,
                                         std::size_t parameters) {
    const auto count = static_cast<double>(points);
    const double all = static_cast<double>(parameters) + 1.0;
    const double rest = count - all - 1.0;
    return {.aicc = rest > 0.0 ? deviance + 2.0 * all + 2.0 * all * (all + 1.0) / rest
                               : std::numeric_limits<double>::infinity(),
            .bic = deviance + all * std::log(count)};
}

} // namespace searle::rheometry::fit
