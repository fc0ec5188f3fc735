#include "rheometry/report/plot.hpp"

#include "markup_check.hpp"
#include "rheometry/report/thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace searle::rheometry::report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Plot plot_of(std::vector<double> x, std::vector<double> y, Scale scale) {
    Plot plot;
    plot.id = "test";
    plot.title = "a < b & \"c\"";
    plot.x.name = RichText{"x < 1 & more"};
    plot.y.name = RichText{"y"};
    plot.x.scale = scale;
    plot.y.scale = scale;
    Series series;
    series.name = RichText{"<series> & co"};
    series.x = std::move(x);
    series.y = std::move(y);
    series.marker = Marker::circle;
    series.stroke = Stroke::solid;
    series.tip = [](std::size_t k) { return "<tip> & " + std::to_string(k); };
    plot.series.push_back(std::move(series));
    return plot;
}

void expect_sound(const std::string& svg) {
    EXPECT_EQ(test::markup_fault(svg), "");
    EXPECT_EQ(test::not_a_number_in(svg), "");
}

TEST(plot, awkward_data_give_sound_drawings) {
    const std::vector<std::vector<double>> columns{{},
                                                   {5.0},
                                                   {0.0},
                                                   {3.0, 3.0, 3.0},
                                                   {0.0, 0.0},
                                                   {-1.0, -2.0},
                                                   {nan, infinity, -infinity},
                                                   {1e-300, 1e300},
                                                   {1e-320, 1.0},
                                                   {-1e308, 1e308},
                                                   {1.0, 1.0 + 1e-15},
                                                   {0.0, 1e-12, nan, 4.0, -3.0}};
    for (const auto& x : columns) {
        for (const auto& y : columns) {
            for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
                Plot plot = plot_of(x, y, scale);
                plot.series.front().error.assign(x.size(), 0.5);
                plot.series.front().shows_direction = true;
                plot.bands = {{-1e300, 2.0, 0}, {nan, 3.0, 0}, {1.0, infinity, 0}};
                plot.band_kinds = {{"lag & <more>", 2}};
                expect_sound(draw(plot).svg);
            }
        }
    }
}

TEST(plot, random_data_give_sound_drawings) {
    std::mt19937_64 random{11};
    std::uniform_real_distribution<double> exponent{-14.0, 14.0};
    std::uniform_int_distribution<int> count{1, 60};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> x;
        std::vector<double> y;
        const double spread = exponent(random) / 14.0;
        for (int k = count(random); k > 0; --k) {
            x.push_back(std::pow(10.0, spread * exponent(random)));
            y.push_back(std::pow(10.0, spread * exponent(random)));
        }
        for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
            const DrawnPlot drawn = draw(plot_of(x, y, scale));
            expect_sound(drawn.svg);
        }
    }
}

TEST(plot, points_that_a_logarithmic_axis_cannot_show_are_counted) {
    const DrawnPlot drawn =
        draw(plot_of({1.0, 0.0, -1.0, 10.0, 100.0}, {1.0, 1.0, 1.0, nan, 5.0}, Scale::logarithmic));
    EXPECT_EQ(drawn.dropped_points, 3u);
    EXPECT_EQ(test::count_of(drawn.svg, "<title>"), 2u);
}

TEST(plot, a_few_points_far_below_all_others_do_not_stretch_a_logarithmic_axis) {
    std::vector<double> x;
    std::vector<double> y;
    for (int k = 1; k <= 40; ++k) {
        x.push_back(k);
        y.push_back(k == 20 ? 1e-15 : k);
    }
    const DrawnPlot drawn = draw(plot_of(x, y, Scale::logarithmic));
    EXPECT_EQ(drawn.dropped_points, 1u);
    EXPECT_EQ(drawn.svg.find(">\u221215<"), std::string::npos); // no label 10^-15
}

TEST(plot, tips_of_points_are_titles_and_escaped) {
    const DrawnPlot drawn = draw(plot_of({1.0, 2.0}, {1.0, 2.0}, Scale::linear));
    EXPECT_NE(drawn.svg.find("<title>&lt;tip&gt; &amp; 1</title>"), std::string::npos);
    EXPECT_EQ(drawn.svg.find("<tip>"), std::string::npos);
}

TEST(plot, the_longest_error_bar_is_measured_in_pixels) {
    // Axis from 0 to 100 + 10 + 4.5 % of the span over 290 pixels: a half-length of 10 is about 25.
    Plot plot = plot_of({0.0, 1.0}, {0.0, 100.0}, Scale::linear);
    plot.series.front().error = {0.0, 10.0};
    EXPECT_NEAR(draw(plot).longest_error_bar, 290.0 * 10.0 / (110.0 * 1.045), 0.5);
    plot.series.front().reports_error_bars = false;
    EXPECT_EQ(draw(plot).longest_error_bar, 0.0);
}

TEST(plot, many_points_are_thinned_and_the_ends_stay) {
    std::vector<double> x;
    std::vector<double> y;
    for (int k = 0; k < 100'000; ++k) {
        x.push_back(k);
        y.push_back(std::sin(1e-4 * k));
    }
    const DrawnPlot drawn = draw(plot_of(x, y, Scale::linear));
    EXPECT_GT(drawn.thinned_points, 99'000u);
    EXPECT_LT(drawn.svg.size(), 150'000u);
    EXPECT_NE(drawn.svg.find("&amp; 0</title>"), std::string::npos);
    EXPECT_NE(drawn.svg.find("&amp; 99999</title>"), std::string::npos);
    expect_sound(drawn.svg);
}

TEST(plot, a_file_carries_its_style_and_its_namespace) {
    const std::string file = svg_file(plot_of({1.0, 2.0}, {1.0, 4.0}, Scale::logarithmic));
    expect_sound(file);
    EXPECT_TRUE(file.starts_with("<?xml"));
    EXPECT_NE(file.find("xmlns=\"http://www.w3.org/2000/svg\""), std::string::npos);
    EXPECT_NE(file.find("<style>"), std::string::npos);
}

TEST(thinning, all_points_stay_below_the_limit_and_no_more_than_the_limit_stays_above) {
    std::vector<Pixel> points;
    for (int k = 0; k < 5000; ++k) {
        points.push_back({0.1 * k, 100.0 * std::sin(0.01 * k)});
    }
    EXPECT_EQ(thinned_by_distance(points, 5000).size(), 5000u);
    const std::vector<std::size_t> kept = thinned_by_distance(points, 300);
    EXPECT_LE(kept.size(), 300u);
    EXPECT_GE(kept.size(), 150u);
    EXPECT_EQ(kept.front(), 0u);
    EXPECT_EQ(kept.back(), 4999u);
}

TEST(thinning, scattered_points_still_obey_the_limit) {
    std::mt19937_64 random{3};
    std::uniform_real_distribution<double> place{0.0, 400.0};
    std::vector<Pixel> points(20'000);
    for (Pixel& point : points) {
        point = {place(random), place(random)};
    }
    EXPECT_LE(thinned_by_distance(points, 400).size(), 400u);
}

TEST(thinning, spaced_points_keep_their_distance_and_both_ends) {
    std::vector<Pixel> points;
    for (int k = 0; k <= 100; ++k) {
        points.push_back({0.5 * k, 0.0});
    }
    points.push_back({nan, 0.0});
    const std::vector<std::size_t> kept = spaced_by(points, 11.0);
    EXPECT_EQ(kept, (std::vector<std::size_t>{0, 22, 44, 66, 88, 100}));
    EXPECT_TRUE(spaced_by({}, 1.0).empty());
}

TEST(thinning, rows_are_thinned_evenly_with_both_ends) {
    const std::vector<std::size_t> kept = thinned_evenly(100'001, 1001);
    ASSERT_EQ(kept.size(), 1001u);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        EXPECT_EQ(kept[k], 100 * k);
    }
    EXPECT_EQ(thinned_evenly(3, 10).size(), 3u);
}

} // namespace
} // namespace searle::rheometry::report
