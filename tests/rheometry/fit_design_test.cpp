#include "rheometry/fit/design.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

namespace fit = searle::rheometry::fit;

fit::FlowData power_law_data(double low, double high, std::size_t count) {
    std::mt19937_64 engine(11);
    std::normal_distribution<double> normal;
    fit::FlowData data;
    data.rates = fit::spread_rates(low, high, count);
    data.lines.assign(count, 0);
    for (const double rate : data.rates)
        data.stresses.push_back(2.0 * std::pow(rate, 0.5) * (1.0 + 0.01 * normal(engine)));
    return data;
}

fit::Candidates candidates(const fit::Model& law, const fit::FitResult& result, std::string name,
                           double low, double high) {
    fit::Candidates made{std::move(name), fit::spread_rates(low, high, 81), {}, {}};
    made.sensitivities = fit::sensitivities(fit::FlowCurveModel(law, made.rates), result);
    return made;
}

fit::Sensitivities present(const fit::Model& law, const fit::FitResult& result,
                           const fit::FlowData& data) {
    return fit::sensitivities(fit::FlowCurveModel(law, data.rates), result);
}

// With relative scatter a power law is a straight line in the logarithms. The determinant of the
// information is the spread of the abscissas: four further points to data in the middle go to both
// ends, two each.
TEST(FitDesign, a_straight_line_is_measured_at_its_ends) {
    const fit::Model& law = *fit::model_named("power-law");
    const fit::FlowData data = power_law_data(0.5, 2.0, 12);
    const fit::FitResult result = fit::fit_flow_curve(law, data, {});
    const fit::Design design = fit::suggest_points(result, present(law, result, data),
                                                   candidates(law, result, "wide", 0.01, 100.0), 4);
    ASSERT_EQ(design.points.size(), 2U);
    EXPECT_DOUBLE_EQ(design.points[0].rate, 0.01);
    EXPECT_DOUBLE_EQ(design.points[1].rate, 100.0);
    EXPECT_EQ(design.points[0].repeats, 2U);
    // Sums of squared distances in ln(rate), before and after: the index' error falls with their
    // root.
    double before = 0.0;
    for (const double rate : data.rates)
        before += std::log(rate) * std::log(rate);
    const double after = before + 4.0 * std::log(100.0) * std::log(100.0);
    EXPECT_NEAR(design.shrinkage[1], std::sqrt(before / after), 1e-3);
}

// What is promised is what comes: the same law fitted to the data and the suggested points.
TEST(FitDesign, promised_standard_errors_come_true) {
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    const std::vector<double> truth{5.0, 0.9, 0.55};
    fit::FlowData data;
    const auto measure = [&](double rate) {
        data.rates.push_back(rate);
        data.stresses.push_back(law.stress(truth, rate) * (1.0 + 0.01 * normal(engine)));
        data.lines.push_back(0);
    };
    for (const double rate : fit::spread_rates(1.0, 100.0, 200))
        measure(rate);
    const fit::FitResult result = fit::fit_flow_curve(law, data, {});
    const fit::Design design = fit::suggest_points(result, present(law, result, data),
                                                   candidates(law, result, "", 0.1, 1000.0), 100);
    for (const fit::DesignPoint& point : design.points)
        for (std::size_t n = 0; n < point.repeats; ++n)
            measure(point.rate);
    const fit::FitResult then = fit::fit_flow_curve(law, data, {});
    for (std::size_t i = 0; i < 3; ++i) {
        // 300 points know their own scatter to 4 %.
        EXPECT_NEAR(then.estimates[i].standard_error / design.standard_errors[i], 1.0, 0.12) << i;
        EXPECT_LT(design.shrinkage[i], 0.6) << i;
    }
}

TEST(FitDesign, the_wider_window_comes_first_and_empty_ones_are_left_out) {
    const fit::Model& law = *fit::model_named("power-law");
    const fit::FlowData data = power_law_data(0.5, 2.0, 12);
    const fit::FitResult result = fit::fit_flow_curve(law, data, {});
    const auto designs = fit::suggest_designs(result, present(law, result, data),
                                              {candidates(law, result, "narrow", 0.2, 5.0),
                                               fit::Candidates{"none", {}, {}, {}},
                                               candidates(law, result, "wide", 0.01, 100.0)},
                                              2);
    ASSERT_EQ(designs.size(), 2U);
    EXPECT_EQ(designs[0].name, "wide");
    EXPECT_LT(designs[0].volume_ratio, designs[1].volume_ratio);
}

} // namespace
