#include "laws/lubrication/near_contact.hpp"
#include "laws/lubrication/near_wall.hpp"

#include <gtest/gtest.h>

namespace searle::laws::lubrication {
namespace {

constexpr double pi = std::numbers::pi;

// The coefficients of 1/xi and ln(1/xi) are found from two gaps; expected ones are Jeffrey &
// Onishi's (1984), as peers.md quotes them.
TEST(NearContact, equal_spheres_have_jeffrey_and_onishis_coefficients) {
    const Film at = film(0.5e-4, 1.0, 1.0, 1.0, Squeeze::both); // xi = 5e-5
    const double log = std::log(1.0 / 5e-5);
    EXPECT_NEAR(at.squeeze / (6 * pi), 0.25 / 5e-5 + 9.0 / 40.0 * log, 1e-9);
    EXPECT_NEAR(at.shear / (6 * pi), log / 6.0, 1e-12);
    EXPECT_NEAR(at.mixed, 0.0, 1e-12);
    // Y_C11 = ln / 5 of one turning sphere; Y_C12 = ln / 20.
    EXPECT_NEAR((at.shear + at.pump) / (8 * pi), 0.2 * log, 1e-12);
    EXPECT_NEAR((at.shear - at.pump) / (8 * pi), 0.05 * log, 1e-12);
    EXPECT_NEAR(at.twist / (8 * pi), 1.2020569 / 8.0, 2e-4);
}

TEST(NearContact, unequal_spheres_have_the_coupling_that_was_not_put_in) {
    for (const double l : {0.1, 0.5, 1.4, 5.0}) {
        const double xi = 1e-4;
        const Film at = film(0.5 * xi * (1 + l), 1.0, l, 1.0, Squeeze::both);
        const double log = std::log(1.0 / xi);
        // Force of sphere 1's own rotation: Y_B11 = -l (4 + l) / (5 (1+l)^2) ln, units 4 pi mu a^2.
        EXPECT_NEAR((at.shear + at.mixed) / (4 * pi * log), l * (4 + l) / (5 * (1 + l) * (1 + l)),
                    1e-12);
        // Torque on 1 of 2's rotation: Y_C12 = 4 l^2 / (5 (1+l)^4) ln, units pi mu (a1+a2)^3.
        const double coupling = at.shear * l + at.mixed * (l - 1.0) - at.pump;
        EXPECT_NEAR(coupling / (pi * std::pow(1 + l, 3) * log),
                    4 * l * l / (5 * std::pow(1 + l, 4)), 1e-12);
        EXPECT_NEAR(at.squeeze / (6 * pi),
                    2 * l * l / std::pow(1 + l, 3) / xi +
                        l * (1 + 7 * l + l * l) / (5 * std::pow(1 + l, 3)) * log,
                    1e-8);
    }
}

TEST(NearContact, loses_power_whatever_the_motion_and_does_not_know_first_from_second) {
    for (const double l : {0.1, 0.5, 1.0, 3.0})
        for (const double xi : {1e-6, 1e-3, 0.1, 0.5, 0.9}) {
            const Film one = film(0.5 * xi * (1 + l), 1.0, l, 1.0, Squeeze::both);
            const Film other = film(0.5 * xi * (1 + l), l, 1.0, 1.0, Squeeze::both);
            EXPECT_GT(one.squeeze, 0.0);
            EXPECT_GT(one.shear * one.pump, one.mixed * one.mixed) << l << ' ' << xi;
            EXPECT_GE(one.twist, 0.0);
            EXPECT_NEAR(other.squeeze / one.squeeze, 1.0, 1e-12);
            EXPECT_NEAR(other.shear / one.shear, 1.0, 1e-12);
            EXPECT_NEAR(other.pump / one.pump, 1.0, 1e-10);
            EXPECT_NEAR(other.mixed, -one.mixed, 1e-12 * one.pump);
        }
}

// Goldman, Cox & Brenner (1967) and Cox & Brenner (1967), the logarithms of their near solutions.
TEST(NearWall, sliding_turning_and_squeezing_have_the_known_coefficients) {
    const double xi = 1e-5;
    const double a = 2.0;
    const double log = std::log(1.0 / xi);
    const Film at = wall_film(xi * a, a, 1.0, Squeeze::both);
    // Sliding without turning: force and torque. The slip is U, then a W.
    EXPECT_NEAR(at.shear / (6 * pi * a * log), 8.0 / 15.0, 1e-12);
    EXPECT_NEAR((at.shear * a + at.mixed) / (8 * pi * a * a * log), 0.1, 1e-12);
    EXPECT_NEAR((at.shear * a + at.mixed) / (6 * pi * a * a * log), 2.0 / 15.0, 1e-12);
    EXPECT_NEAR((at.shear * a * a + 2 * at.mixed * a + at.pump) / (8 * pi * a * a * a * log), 0.4,
                1e-12);
    EXPECT_NEAR(at.squeeze / (6 * pi * a), 1.0 / xi + 0.2 * log, 1e-6);
    // 1.2020569 is zeta(3), Jeffery's (1915) torque at contact.
    EXPECT_NEAR(1.0 + twist_beside_wall(0.0), 1.2020569, 4e-3);
    EXPECT_NEAR(1.0 + twist_beside_wall(1e-3), 1.2020569, 6e-3); // 2.7e-3 of it truncation
    // Far away the wall's image: 1 + (a / h)^3 / 8 of the centre's distance h.
    EXPECT_NEAR(twist_beside_wall(19.0) * 8.0 * std::pow(20.0, 3), 1.0, 2e-3);
}

// The wall is a sphere without end: what is left falls as the ratio of radii. Logarithms are
// compared by their factors, for the scale in them differs.
TEST(NearWall, is_the_limit_of_a_large_second_sphere) {
    double before = 1.0;
    for (const double ratio : {1e2, 1e3, 1e4}) {
        const double gap = 1e-8;
        const Film pair = film(gap, 1.0, ratio, 1.0, Squeeze::leading);
        const Film wall = wall_film(gap, 1.0, 1.0, Squeeze::leading);
        const double scale =
            std::log(1.0 / gap) / std::log(0.5 * (1.0 + ratio) / gap); // of the logarithms
        const double off = std::max({std::abs(pair.squeeze / wall.squeeze - 1.0),
                                     std::abs(scale * pair.shear / wall.shear - 1.0),
                                     std::abs(scale * pair.mixed / wall.mixed - 1.0),
                                     std::abs(scale * pair.pump / wall.pump - 1.0)});
        EXPECT_LT(off, 10.0 / ratio);
        EXPECT_LT(off, 0.12 * before);
        before = off;
    }
}

TEST(NearWall, loses_power_whatever_the_motion) {
    for (const double xi : {1e-6, 1e-3, 0.1, 0.5, 0.9}) {
        const Film at = wall_film(xi, 1.0, 1.0, Squeeze::both);
        EXPECT_GT(at.shear * at.pump, at.mixed * at.mixed);
        EXPECT_GT(at.squeeze, 0.0);
        EXPECT_GT(at.twist, 0.0);
    }
}

} // namespace
} // namespace searle::laws::lubrication
