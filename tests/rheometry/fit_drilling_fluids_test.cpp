// Measured drilling fluids. The expected parameters come from an independent fit in Python
// (scipy.optimize.least_squares with analytic derivatives from four starts, polished by
// Gauss-Newton to rounding), weights 1/stress ("relative") and 1 ("absolute").

#include "places.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/tables/flow_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace {

namespace fit = searle::rheometry::fit;

const std::filesystem::path file =
    std::filesystem::path(SEARLE_SOURCE_DIR) / "../shared/data/drilling_fluids.txt";

struct Expected {
    const char* curve;
    fit::Weighting weighting;
    double values[3];
    double errors[3];
};

constexpr auto relative = fit::Weighting::relative;
constexpr auto absolute = fit::Weighting::absolute;

const Expected expected[] = {{"49 KCl/Polymer 1.75sg 10degC",
                              relative,
                              {2.9476594, 1.230097856, 0.5192917006},
                              {0.039755827, 0.029398595, 0.005202273}},
                             {"49 KCl/Polymer 1.75sg 10degC",
                              absolute,
                              {3.073899069, 1.140076832, 0.5353415218},
                              {0.05031563, 0.030776597, 0.0054375111}},
                             {"53 KCl/Polymer 1.50sg 10degC",
                              relative,
                              {2.752645293, 1.44832618, 0.4277996827},
                              {0.056426217, 0.045514557, 0.0063553336}},
                             {"53 KCl/Polymer 1.50sg 10degC",
                              absolute,
                              {2.900810225, 1.331817001, 0.4444272848},
                              {0.065085846, 0.046331588, 0.0066480268}},
                             {"97 Xan+50 KCl+0 barite 9%",
                              relative,
                              {4.990572398, 2.129268899, 0.3758412934},
                              {0.12145813, 0.10139387, 0.0090261241}},
                             {"97 Xan+50 KCl+0 barite 9%",
                              absolute,
                              {5.217158042, 1.942682613, 0.3931127102},
                              {0.12914209, 0.098962512, 0.0093327232}},
                             {"17 KCl Xan 1.50sg 10degC",
                              relative,
                              {2.539796544, 1.121595376, 0.4665713919},
                              {0.058874058, 0.041370524, 0.0067457744}},
                             {"17 KCl Xan 1.50sg 10degC",
                              absolute,
                              {2.78679166, 0.9602130719, 0.4938901383},
                              {0.069411899, 0.036303457, 0.0063042261}},
                             {"25 Versatec 1.37sg 10degC",
                              relative,
                              {2.014025606, 0.6044052796, 0.675913476},
                              {0.050996536, 0.027471262, 0.0092624635}},
                             {"25 Versatec 1.37sg 10degC",
                              absolute,
                              {2.383416886, 0.4436668586, 0.7344753175},
                              {0.083932144, 0.021071498, 0.0083416516}},
                             {"1 Bentonite NaCl Unweighted 10degC",
                              relative,
                              {2.033612611, 0.7493332548, 0.5366511476},
                              {0.072409269, 0.046576337, 0.011691785}},
                             {"1 Bentonite NaCl Unweighted 10degC",
                              absolute,
                              {2.281347812, 0.6072561579, 0.5742029311},
                              {0.087614095, 0.035542056, 0.009794071}}};

TEST(FitDrillingFluids, herschel_bulkley_matches_an_independent_fit_to_six_digits) {
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "the measured data (shared/data/drilling_fluids.txt) are not here";
    const searle::rheometry::FlowCurveFile read = searle::rheometry::read_flow_curves(file);
    for (const Expected& each : expected) {
        const auto curve =
            std::find_if(read.curves.begin(), read.curves.end(),
                         [&](const auto& candidate) { return candidate.name == each.curve; });
        ASSERT_NE(curve, read.curves.end()) << each.curve;
        fit::FitOptions options;
        options.weighting = each.weighting;
        const fit::FitResult result = fit::fit_flow_curve(
            *fit::model_named("herschel-bulkley"), fit::select_points(curve->points, {}), options);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(result.estimates[i].value / each.values[i], 1.0, 5e-7) << each.curve;
            EXPECT_NEAR(result.estimates[i].standard_error / each.errors[i], 1.0, 5e-6)
                << each.curve;
        }
    }
}

TEST(FitDrillingFluids, nine_of_ten_curves_are_fitted_within_two_percent) {
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "the measured data (shared/data/drilling_fluids.txt) are not here";
    const searle::rheometry::FlowCurveFile read = searle::rheometry::read_flow_curves(file);
    ASSERT_EQ(read.curves.size(), 97U);
    std::size_t good = 0;
    for (const auto& curve : read.curves) {
        const fit::FitResult result = fit::fit_flow_curve(*fit::model_named("herschel-bulkley"),
                                                          fit::select_points(curve.points, {}), {});
        EXPECT_TRUE(result.converged) << curve.name;
        good += result.rms_relative <= 0.02 ? 1 : 0;
    }
    EXPECT_GE(good, 88U);
}

} // namespace
