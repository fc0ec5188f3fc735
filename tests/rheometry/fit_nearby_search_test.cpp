#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/nearby_search.hpp"
#include "rheometry/fit/prediction.hpp"
#include "rheometry/fit/weighted_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

namespace fit = searle::rheometry::fit;

/// Data with 2 % of scatter: Herschel-Bulkley's, or, for laws with plateaus, a Cross fluid's with
/// both plateaus among the data. Plateaus that lie outside of them are valleys without a bottom,
/// where the place of the minimum is a matter of rounding.
fit::FlowData scattered(unsigned seed, bool has_plateaus = false) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    fit::FlowData data;
    data.rates = fit::spread_rates(has_plateaus ? 1e-3 : 0.1, has_plateaus ? 1e5 : 1000.0, 41);
    data.lines.assign(data.rates.size(), 0);
    for (const double rate : data.rates) {
        const double stress =
            has_plateaus ? rate * (0.05 + (10.0 - 0.05) / (1.0 + std::pow(2.0 * rate, 0.7)))
                         : 5.0 + 0.9 * std::pow(rate, 0.55);
        data.stresses.push_back(stress * (1.0 + 0.02 * normal(engine)));
    }
    return data;
}

// Against the general solver (Ceres), from a start that is off by a factor; every law.
TEST(NearbySearch, finds_the_minimum_of_the_general_search) {
    for (const fit::Model& law : fit::models()) {
        const fit::FlowData data =
            scattered(1, law.name == "carreau-yasuda" || law.name == "cross");
        const fit::FitResult known = fit::fit_flow_curve(law, data, {});
        const fit::FlowCurveModel forward(law, data.rates);
        const fit::WeightedResiduals residuals(forward, data.stresses, {},
                                               fit::Weighting::relative);
        const auto problem =
            residuals.problem(fit::parameters_for(law, fit::scale_of(data.rates, data.stresses)));
        std::vector<double> start = known.search;
        for (double& coordinate : start)
            coordinate += 0.1 * std::max(0.5, std::abs(coordinate));
        const fit::Minimum found =
            fit::minimise_nearby(problem, start, {.relative_decrease = 1e-12});
        EXPECT_TRUE(found.converged) << law.name;
        EXPECT_NEAR(found.sum_of_squares / known.sum_of_squares, 1.0, 1e-6) << law.name;
    }
}

// A quadratic bowl whose bottom (3, 4) lies outside of x <= 2: the constrained minimum is at x = 2
// and, the residuals being x - 3 and y - x - 1, y = 3.
TEST(NearbySearch, stops_at_bounds_and_slides_along_them) {
    fit::LeastSquaresProblem problem;
    problem.residuals = 2;
    problem.low = {-10.0, -10.0};
    problem.high = {2.0, 10.0};
    problem.evaluate = [](std::span<const double> at, std::span<double> residuals,
                          std::span<double> jacobian) {
        residuals[0] = at[0] - 3.0;
        residuals[1] = at[1] - at[0] - 1.0;
        if (!jacobian.empty()) {
            const std::vector<double> slopes{1.0, 0.0, -1.0, 1.0};
            std::copy(slopes.begin(), slopes.end(), jacobian.begin());
        }
        return true;
    };
    const fit::Minimum found =
        fit::minimise_nearby(problem, std::vector<double>{-5.0, 7.0}, {.relative_decrease = 1e-12});
    EXPECT_DOUBLE_EQ(found.parameters[0], 2.0);
    EXPECT_NEAR(found.parameters[1], 3.0, 1e-9);
    EXPECT_NEAR(found.sum_of_squares, 1.0, 1e-12);
}

TEST(NearbySearch, a_parameter_with_equal_bounds_stays) {
    const fit::FlowData data = scattered(2);
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    const fit::FlowCurveModel forward(law, data.rates);
    const fit::WeightedResiduals residuals(forward, data.stresses, {}, fit::Weighting::relative);
    auto problem =
        residuals.problem(fit::parameters_for(law, fit::scale_of(data.rates, data.stresses)));
    problem.low[2] = problem.high[2] = 0.6;
    const fit::Minimum found = fit::minimise_nearby(
        problem, law.search(std::vector<double>{4.0, 1.0, 0.6}), {.relative_decrease = 1e-12});
    EXPECT_EQ(found.parameters[2], 0.6);
    EXPECT_NEAR(found.sum_of_squares, fit::minimise(problem, found.parameters).sum_of_squares,
                1e-9 * found.sum_of_squares);
}

} // namespace
