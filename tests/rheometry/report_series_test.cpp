#include "rheometry/report/describe_fluid.hpp"
#include "rheometry/report/deviation.hpp"
#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/regime_shading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::rheometry::report {
namespace {

Rheogram rheogram_at(const std::vector<double>& rates) {
    Rheogram rheogram;
    for (const double rate : rates) {
        RheogramPoint point;
        point.time = static_cast<double>(rheogram.points.size());
        point.shear_rate = rate;
        point.shear_stress = point.steady_stress = 2.0 * rate;
        point.viscosity = 2.0;
        rheogram.points.push_back(point);
    }
    return rheogram;
}

TEST(report_series, a_fluid_is_described_by_the_parameters_of_its_law_in_their_order) {
    const FluidDescription fluid =
        describe_fluid(laws::flow::HerschelBulkley{5.0, 0.6, 0.4}, 1200.0);
    EXPECT_EQ(fluid.model, "herschel-bulkley");
    ASSERT_EQ(fluid.parameters.size(), 3u);
    EXPECT_EQ(fluid.parameters[0].key, "yield_stress");
    EXPECT_EQ(fluid.parameters[0].value, 5.0);
    EXPECT_EQ(fluid.parameters[1].key, "consistency");
    EXPECT_EQ(fluid.parameters[1].value, 0.6);
    EXPECT_EQ(fluid.parameters[2].key, "flow_index");
    EXPECT_EQ(fluid.parameters[2].value, 0.4);
    EXPECT_DOUBLE_EQ(fluid.true_stress(10.0), 5.0 + 0.6 * std::pow(10.0, 0.4));
    EXPECT_EQ(fluid.density, 1200.0);
}

TEST(report_series, bands_meet_halfway_between_points_and_reach_the_axes_ends) {
    Rheogram rheogram = rheogram_at({1.0, 2.0, 3.0, 4.0, 5.0});
    auto& points = rheogram.points;
    points[0].regime = points[1].regime = "lag";
    points[2].regime = "laminar";
    points[3].regime = "taylor-vortices";
    points[4].regime = "taylor-vortices+end-flow";
    const RegimeShading shading = shade_regimes(points, column(rheogram, Quantity::shear_rate));
    ASSERT_EQ(shading.kinds.size(), 3u);
    EXPECT_EQ(shading.kinds[0].name, "inertial lag");
    EXPECT_EQ(shading.kinds[1].name, "Taylor vortices");
    ASSERT_EQ(shading.bands.size(), 3u);
    EXPECT_LT(shading.bands[0].from, -1e200);
    EXPECT_DOUBLE_EQ(shading.bands[0].to, 2.5);
    EXPECT_DOUBLE_EQ(shading.bands[1].from, 3.5);
    EXPECT_GT(shading.bands[1].to, 1e200);
    EXPECT_DOUBLE_EQ(shading.bands[2].from, 4.5);
}

TEST(report_series, bands_do_not_depend_on_the_points_order) {
    Rheogram rheogram = rheogram_at({5.0, 1.0, 3.0});
    rheogram.points[0].regime = "taylor-vortices";
    const RegimeShading shading =
        shade_regimes(rheogram.points, column(rheogram, Quantity::shear_rate));
    ASSERT_EQ(shading.bands.size(), 1u);
    EXPECT_DOUBLE_EQ(shading.bands[0].from, 4.0);
}

TEST(report_series, a_loop_is_split_into_rising_and_falling_points_without_losing_one) {
    const Rheogram rheogram = rheogram_at({1.0, 2.0, 3.0, 3.0, 2.0, 1.0, 4.0});
    EXPECT_TRUE(passes_rates_twice(rheogram));
    EXPECT_FALSE(passes_rates_twice(rheogram_at({1.0, 1.0, 2.0})));
    Conversion conversion;
    conversion.stress_per_torque = 1.0;
    const CurveView view = view_of(rheogram, Quantity::shear_rate, Quantity::shear_stress, true);
    std::size_t filled = 0;
    std::size_t open = 0;
    std::size_t lines = 0;
    for (const Series& series :
         computed_series(rheogram, conversion, view, true, RichText{"computed"}, 0)) {
        if (series.marker == Marker::none) {
            ++lines;
        } else {
            (series.open_marker ? open : filled) += series.x.size();
        }
    }
    EXPECT_EQ(lines, 3u);
    EXPECT_EQ(filled, 5u); // 1 2 3 3 and the last 4
    EXPECT_EQ(open, 2u);
}

TEST(report_series, a_law_over_rates_of_both_signs_is_odd_with_a_hole_at_its_yield_stress) {
    const FluidDescription fluid = describe_fluid(laws::flow::Bingham{3.0, 1.0}, 1000.0);
    CurveView view;
    view.x = Quantity::shear_rate;
    view.y = Quantity::shear_stress;
    const Series series = law_series(fluid.true_stress, -2.0, 2.0, view, Scale::linear);
    int holes = 0;
    for (std::size_t k = 0; k < series.x.size(); ++k) {
        if (std::isnan(series.x[k])) {
            ++holes;
            continue;
        }
        EXPECT_GE(std::abs(series.y[k]), 3.0);
        EXPECT_EQ(series.y[k] < 0.0, series.x[k] < 0.0);
    }
    EXPECT_EQ(holes, 1);
}

TEST(report_series, the_deviation_is_that_of_the_viscosity_from_the_laws) {
    Rheogram rheogram = rheogram_at({0.0, 1.0, 10.0});
    rheogram.points[1].shear_stress = 2.5; // the law gives 2
    const Deviation deviation = largest_deviation(rheogram, [](double rate) { return 2.0 * rate; });
    EXPECT_DOUBLE_EQ(deviation.largest, 0.25);
    EXPECT_EQ(deviation.at_rate, 1.0);
    EXPECT_TRUE(std::isnan(largest_deviation(rheogram, nullptr).largest));
}

} // namespace
} // namespace searle::rheometry::report
