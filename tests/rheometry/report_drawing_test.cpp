#include "rheometry/report/geometry_drawing.hpp"

#include "markup_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace searle::rheometry::report {
namespace {

void expect_sound(const std::string& svg) {
    EXPECT_EQ(test::markup_fault(svg), "");
    EXPECT_EQ(test::not_a_number_in(svg), "");
}

bool says(const std::string& svg, std::string_view text) {
    return svg.find(text) != std::string::npos;
}

TEST(report_drawing, a_single_gap_shows_its_dimensions_and_its_narrow_gap_magnified) {
    const std::string svg = geometry_drawing(geometry::ConcentricCylinders{0.014, 0.015, 0.042});
    expect_sound(svg);
    EXPECT_TRUE(says(svg, "14\u00a0mm"));
    EXPECT_TRUE(says(svg, "15\u00a0mm"));
    EXPECT_TRUE(says(svg, "42\u00a0mm"));
    EXPECT_TRUE(says(svg, ">1\u00a0mm"));
    EXPECT_TRUE(says(svg, "magnified"));
    EXPECT_TRUE(says(svg, "to scale"));
}

TEST(report_drawing, a_wide_gap_needs_no_magnifier) {
    const std::string svg = geometry_drawing(geometry::ConcentricCylinders{0.010, 0.020, 0.042});
    expect_sound(svg);
    EXPECT_FALSE(says(svg, "magnified"));
    EXPECT_TRUE(says(svg, ">10\u00a0mm"));
}

TEST(report_drawing, extreme_proportions_are_said_to_be_off_scale) {
    const std::string svg = geometry_drawing(geometry::ConcentricCylinders{0.014, 0.015, 2.0});
    expect_sound(svg);
    EXPECT_TRUE(says(svg, "height not to the scale of the radii"));
    EXPECT_TRUE(says(geometry_drawing(geometry::Box{1e-4, 1.0, 1.0}), "not to scale"));
    EXPECT_FALSE(says(geometry_drawing(geometry::Box{5e-5, 5e-5, 5e-5}), "not to scale"));
}

TEST(report_drawing, a_double_gap_shows_both_gaps_and_the_rotor) {
    const std::string svg =
        geometry_drawing(geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.055});
    expect_sound(svg);
    EXPECT_TRUE(says(svg, "0.38\u00a0mm"));
    EXPECT_TRUE(says(svg, "0.42\u00a0mm"));
    EXPECT_TRUE(says(svg, "1.58\u00a0mm"));
    EXPECT_TRUE(says(svg, "rotor, turns"));
}

TEST(report_drawing, a_din_bob_names_its_patches_and_its_cone) {
    geometry::DinBob bob;
    bob.bob_radius = 0.014;
    bob.cup_radius = 0.0152;
    const std::string svg = geometry_drawing(bob);
    expect_sound(svg);
    for (const char* text : {"bob, turns", "cup, fixed", "cup floor", "free surface", "120\u00b0",
                             "4.2\u00a0mm", "15.2\u00a0mm"}) {
        EXPECT_TRUE(says(svg, text)) << text;
    }
}

TEST(report_drawing, instruments_of_any_size_give_sound_drawings) {
    std::mt19937_64 random{5};
    std::uniform_real_distribution<double> size{-9.0, 3.0};
    std::uniform_real_distribution<double> ratio{-7.0, 2.5};
    const auto length = [&] { return std::pow(10.0, size(random)); };
    const auto widened = [&](double radius) {
        return radius * (1.0 + std::pow(10.0, ratio(random)));
    };
    for (int trial = 0; trial < 300; ++trial) {
        const double bob = length();
        expect_sound(geometry_drawing(geometry::ConcentricCylinders{bob, widened(bob), length()}));
        geometry::DoubleGap two;
        two.radii[0] = length();
        for (std::size_t k = 1; k < 4; ++k) {
            two.radii[k] = widened(two.radii[k - 1]);
        }
        two.height = length();
        expect_sound(geometry_drawing(two));
        geometry::DinBob din;
        din.bob_radius = bob;
        din.cup_radius = widened(bob);
        din.length_ratio = std::pow(10.0, ratio(random));
        din.shaft_ratio = 0.01 + 0.98 * (ratio(random) + 7.0) / 9.5;
        expect_sound(geometry_drawing(din));
        expect_sound(geometry_drawing(geometry::Box{length(), length(), length()}));
    }
}

} // namespace
} // namespace searle::rheometry::report
