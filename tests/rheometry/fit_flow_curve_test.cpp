#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/prediction.hpp"
#include "rheometry/fit/starting_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

namespace fit = searle::rheometry::fit;

/// A truth per law with everything in sight of rates 0.01 ... 1000 1/s.
std::vector<double> truth_of(const fit::Model& law) {
    if (law.name == "newtonian")
        return {0.8};
    if (law.name == "bingham")
        return {4.0, 0.2};
    if (law.name == "power-law")
        return {2.0, 0.45};
    if (law.name == "herschel-bulkley")
        return {5.0, 0.9, 0.55};
    if (law.name == "casson")
        return {3.0, 0.05};
    if (law.name == "carreau-yasuda")
        return {20.0, 0.05, 2.0, 0.3, 1.5};
    if (law.name == "cross")
        return {20.0, 0.05, 2.0, 0.3};
    if (law.name == "sisko")
        return {0.08, 3.0, 0.3};
    if (law.name == "ellis")
        return {12.0, 9.0, 2.4};
    return {3.0, 9.0, 0.05, 12.0}; // windhab
}

fit::FlowData curve_of(const fit::Model& law, const std::vector<double>& truth, double noise,
                       unsigned seed, std::size_t count = 41) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    fit::FlowData data;
    data.rates = fit::spread_rates(0.01, 1000.0, count);
    data.lines.assign(count, 0);
    for (const double rate : data.rates)
        data.stresses.push_back(law.stress(truth, rate) * (1.0 + noise * normal(engine)));
    return data;
}

// Data without scatter: the parameters that made them, to 7 digits, without a guess from outside.
TEST(FitFlowCurve, exact_data_give_back_their_parameters_for_every_law) {
    for (const fit::Model& law : fit::models()) {
        const std::vector<double> truth = truth_of(law);
        const fit::FitResult result = fit::fit_flow_curve(law, curve_of(law, truth, 0.0, 1), {});
        for (std::size_t i = 0; i < truth.size(); ++i)
            EXPECT_NEAR(result.estimates[i].value / truth[i], 1.0, 1e-7)
                << law.name << " " << law.parameters[i].key;
    }
}

// Exact derivatives against central differences; the step's error is of order 1e-8.
TEST(FitFlowCurve, derivatives_match_differences_for_every_law) {
    for (const fit::Model& law : fit::models()) {
        const std::vector<double> search = law.search(truth_of(law));
        const std::vector<double> rates{0.02, 0.7, 30.0, 800.0};
        std::vector<double> stresses(rates.size());
        std::vector<double> jacobian(rates.size() * search.size());
        law.stresses(search, rates, stresses, jacobian);
        for (std::size_t i = 0; i < search.size(); ++i) {
            const double step = 1e-5 * std::max(1.0, std::abs(search[i]));
            std::vector<double> up = search;
            std::vector<double> down = search;
            up[i] += step;
            down[i] -= step;
            std::vector<double> above(rates.size());
            std::vector<double> below(rates.size());
            law.stresses(up, rates, above, {});
            law.stresses(down, rates, below, {});
            for (std::size_t k = 0; k < rates.size(); ++k)
                EXPECT_NEAR(jacobian[k * search.size() + i], (above[k] - below[k]) / (2.0 * step),
                            1e-6 * stresses[k])
                    << law.name << " " << law.parameters[i].key << " at " << rates[k];
        }
    }
}

// A law that contains a simpler one can always do at least as well: rounding apart, it must.
TEST(FitFlowCurve, no_law_fits_worse_than_one_it_contains) {
    for (const fit::Model& maker : fit::models())
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const fit::FlowData data = curve_of(maker, truth_of(maker), 0.03, seed, 15);
            fit::FitOptions options;
            options.profile_intervals = false;
            for (const fit::Model& law : fit::models()) {
                const double own = fit::fit_flow_curve(law, data, options).sum_of_squares;
                for (const std::string_view name : fit::contained_in(law))
                    EXPECT_LE(
                        own,
                        fit::fit_flow_curve(*fit::model_named(name), data, options).sum_of_squares *
                            (1.0 + 1e-9))
                        << law.name << " against " << name << " on " << maker.name;
            }
        }
}

// 600 data sets, 2 % scatter: 95 % +- 3 binomial standard deviations (0.89 %) is 92.3 ... 97.7 %.
TEST(FitFlowCurve, intervals_hold_the_truth_as_often_as_they_say) {
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    const std::vector<double> truth = truth_of(law);
    std::vector<int> held(3);
    for (unsigned seed = 1; seed <= 600; ++seed) {
        const fit::FitResult result =
            fit::fit_flow_curve(law, curve_of(law, truth, 0.02, seed, 12), {});
        for (std::size_t i = 0; i < 3; ++i)
            held[i] += truth[i] >= result.estimates[i].low && truth[i] <= result.estimates[i].high;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GE(held[i], 554) << law.parameters[i].key;
        EXPECT_LE(held[i], 586) << law.parameters[i].key;
    }
}

// Where a law is linear in its parameters the profile's interval is the textbook's: value +- t s.
TEST(FitFlowCurve, profile_interval_of_a_linear_law_is_students) {
    const fit::Model& law = *fit::model_named("bingham");
    const fit::FlowData data = curve_of(law, truth_of(law), 0.02, 3, 20);
    const fit::FitResult result = fit::fit_flow_curve(law, data, {});
    for (const fit::Estimate& estimate : result.estimates) {
        const double reach = 2.10092204 * estimate.standard_error; // Student's t, 18, 97.5 %
        EXPECT_NEAR(estimate.low, estimate.value - reach, 2e-3 * reach) << estimate.parameter.key;
        EXPECT_NEAR(estimate.high, estimate.value + reach, 2e-3 * reach) << estimate.parameter.key;
    }
}

TEST(FitFlowCurve, power_law_data_show_no_yield_stress_and_say_so) {
    const fit::Model& law = *fit::model_named("power-law");
    const fit::FitResult result = fit::fit_flow_curve(*fit::model_named("herschel-bulkley"),
                                                      curve_of(law, truth_of(law), 0.02, 4), {});
    EXPECT_TRUE(result.estimates[0].low_open);
    EXPECT_EQ(result.estimates[0].low, 0.0);
    EXPECT_TRUE(
        std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string& warning) {
            return warning.starts_with("yield_stress is ");
        }));
}

TEST(FitFlowCurve, ranking_puts_the_law_that_made_the_data_first) {
    for (const char* name : {"bingham", "herschel-bulkley", "casson", "windhab"}) {
        const fit::Model& law = *fit::model_named(name);
        const auto results = fit::fit_all(fit::models(), curve_of(law, truth_of(law), 0.01, 8), {});
        EXPECT_EQ(results.size(), fit::models().size());
        EXPECT_EQ(results.front().model, name);
    }
}

// One point in error by a factor of 5: the robust losses stay within 2 % of the truth's flow index.
TEST(FitFlowCurve, robust_loss_is_not_drawn_by_an_outlier) {
    const fit::Model& law = *fit::model_named("power-law");
    fit::FlowData data = curve_of(law, truth_of(law), 0.01, 5);
    data.stresses[0] /= 5.0;
    for (const fit::Loss loss : {fit::Loss::huber, fit::Loss::cauchy}) {
        fit::FitOptions options;
        options.loss = loss;
        EXPECT_NEAR(fit::fit_flow_curve(law, data, options).estimates[1].value, 0.45, 0.009);
    }
    EXPECT_GT(std::abs(fit::fit_flow_curve(law, data, {}).estimates[1].value - 0.45), 0.009);
}

TEST(FitFlowCurve, held_parameter_keeps_its_value) {
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    fit::FitOptions options;
    options.bounds["flow_index"] = {0.5, 0.5};
    const fit::FitResult result =
        fit::fit_flow_curve(law, curve_of(law, truth_of(law), 0.01, 6), options);
    EXPECT_EQ(result.estimates[2].value, 0.5);
    EXPECT_EQ(result.degrees_of_freedom, 39U);
}

TEST(FitFlowCurve, too_few_points_are_an_error_that_says_so) {
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    fit::FlowData data = curve_of(law, truth_of(law), 0.0, 1, 2);
    try {
        (void)fit::fit_flow_curve(law, data, {});
        FAIL() << "two points gave three parameters";
    } catch (const fit::FitError& error) {
        EXPECT_NE(std::string(error.what()).find("2 usable points"), std::string::npos);
    }
}

TEST(FitFlowCurve, equal_stresses_give_a_result_with_a_remark) {
    std::vector<fit::MeasuredPoint> points;
    for (const double rate : {1.0, 3.0, 10.0, 30.0, 100.0})
        points.push_back({.rate = rate, .stress = 7.0, .deviation = NAN, .line = 0, .regime = {}});
    const fit::FlowData data = fit::select_points(points, {});
    const fit::FitResult result = fit::fit_flow_curve(*fit::model_named("bingham"), data, {});
    EXPECT_NEAR(result.fitted.front(), 7.0, 0.05);
    EXPECT_TRUE(
        std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string& warning) {
            return warning.find("all stresses are equal") != std::string::npos;
        }));
}

TEST(FitFlowData, unusable_points_are_left_out_with_their_reasons) {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const std::vector<fit::MeasuredPoint> points{{10.0, 5.0, missing, 2, ""},
                                                 {0.0, 1.0, missing, 3, ""},
                                                 {20.0, -4.0, missing, 4, ""},
                                                 {missing, 4.0, missing, 5, ""},
                                                 {1.0, missing, missing, 6, ""},
                                                 {5.0, 3.0, missing, 7, "laminar"},
                                                 {900.0, 50.0, missing, 8, "lag+taylor-vortices"},
                                                 {-2.0, -2.0, missing, 9, ""},
                                                 {30.0, 8.0, missing, 10, ""},
                                                 {40.0, 9.0, missing, 11, "laminar"}};
    const fit::FlowData data = fit::select_points(points, {});
    EXPECT_EQ(data.rates, (std::vector<double>{2.0, 5.0, 10.0, 30.0, 40.0}));
    ASSERT_EQ(data.excluded.size(), 5U);
    EXPECT_EQ(data.excluded[0].point.line, 3U);
    EXPECT_NE(data.excluded[1].reason.find("sign"), std::string::npos);
    EXPECT_NE(data.excluded[4].reason.find("lag"), std::string::npos);
}

// Expected number: enumeration by hand of all 20 orders of three + and three -: 2 have 2 runs, 4
// have 3.
TEST(FitStatistics, runs_probability_is_exact) {
    const auto test = fit::runs_test(std::vector<double>{1, 1, 1, -1, -1, 1 - 2.0});
    ASSERT_TRUE(test);
    EXPECT_EQ(test->runs, 2U);
    EXPECT_NEAR(test->probability, 2.0 / 20.0, 1e-12);
    const auto three = fit::runs_test(std::vector<double>{1, 1, -1, -1, -1, 1});
    EXPECT_NEAR(three->probability, 6.0 / 20.0, 1e-12);
}

} // namespace
