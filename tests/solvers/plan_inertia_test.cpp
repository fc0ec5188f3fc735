#include "solvers/plan_inertia.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace searle::solvers {
namespace {

using laws::flow::AnyFlowLaw;
using radial::AnnularGap;

// Origin: physics notes, section 2: water of nu = 1.00339 mm^2/s between 14 and 15 mm, T = 0.2996
// s; the further digits from the closed form g'(R_bob) / (-2 B / R_bob^2) with 50 digits (mpmath).
TEST(NewtonianLagTime, water_between_14_and_15_mm) {
    EXPECT_NEAR(newtonian_lag_time({0.014, 0.015}, 1.00339e-6), 0.299579622724617, 1e-13);
}

// Origin: the same closed form with 50 digits, R = 1 m and nu = 1 m^2/s. The gap's width itself has
// a rounding error of 1e-16 / width, twice that in T.
TEST(NewtonianLagTime, equals_the_closed_form_from_narrow_to_wide_gaps) {
    struct Expected {
        double width;
        double inner;
    };
    for (const auto& [width, expected] : std::vector<Expected>{{1e-6, 3.3333283333396667e-13},
                                                               {1e-3, 3.3283396590921388e-7},
                                                               {0.1, 0.0028898745602361818},
                                                               {1.0, 0.11834812037329687},
                                                               {19.0, 1.1269326872451083}}) {
        EXPECT_NEAR(newtonian_lag_time({1.0, 1.0 + width}, 1.0) / expected, 1.0,
                    1e-13 + 4e-16 / width);
    }
}

TEST(NewtonianLagTime, turning_outer_wall_equals_its_closed_form) {
    struct Expected {
        double width;
        double outer;
    };
    for (const auto& [width, expected] : std::vector<Expected>{{1e-6, 3.3333383333346667e-13},
                                                               {0.1, 0.0038465894362692397},
                                                               {1.0, 0.96209812037329687},
                                                               {19.0, 19851.501620187245}}) {
        EXPECT_NEAR(newtonian_lag_time({1.0, 1.0 + width}, 1.0, TurningWall::outer) / expected, 1.0,
                    1e-13 + 4e-16 / width);
    }
}

TEST(NewtonianLagTime, narrow_gap_is_a_third_of_the_diffusion_time) {
    for (const double width : {1e-5, 1e-9, 1e-12}) {
        const AnnularGap gap{1.0, 1.0 + width};
        const double diffusion = gap.width() * gap.width();
        EXPECT_NEAR(newtonian_lag_time(gap, 1.0) * 3.0 / diffusion, 1.0, 2.0 * width + 1e-12);
    }
}

GapResponse response_of(const AnnularGap& gap, const AnyFlowLaw& law, double density, double omega,
                        TurningWall wall) {
    return gap_response(gap, law, density, radial::steady_gap_flow(gap, law, omega), wall);
}

// The general formula with the tangent viscosity must contain the Newtonian one.
TEST(GapResponse, newtonian_inertia_is_lag_time_times_resistance) {
    for (const double width : {1e-6, 1e-2, 0.3, 1.0, 19.0}) {
        for (const TurningWall wall : {TurningWall::inner, TurningWall::outer}) {
            const AnnularGap gap{0.01, 0.01 * (1.0 + width)};
            const AnyFlowLaw law = laws::flow::Newtonian{2.0};
            const double torque_per_speed =
                radial::steady_gap_flow(gap, law, 1.0).torque_per_length;
            const double expected = newtonian_lag_time(gap, 2.0 / 1100.0, wall) * torque_per_speed;
            EXPECT_NEAR(response_of(gap, law, 1100.0, 3.0, wall).inertia / expected, 1.0, 1e-6);
        }
    }
}

// Origin: independent evaluation with mpmath (25 digits): Omega(r) by quadrature of the flow law,
// d Omega / d omega by a central difference in the wall stress, then 2 pi rho integral of its
// square times r^3, with the plug that turns with an outer rotor added.
TEST(GapResponse, inertia_of_yielding_and_power_law_fluids_equals_independent_quadrature) {
    struct Expected {
        AnnularGap gap;
        AnyFlowLaw law;
        double omega;
        double density;
        double inner;
        double outer;
    };
    using laws::flow::Bingham;
    using laws::flow::HerschelBulkley;
    using laws::flow::PowerLaw;
    const std::vector<Expected> cases{
        {{0.010, 0.020},
         HerschelBulkley{20.0, 2.0, 0.4},
         0.05,
         1000.0,
         7.1277665253e-7,
         0.000233806053599},
        {{0.014, 0.015},
         HerschelBulkley{5.0, 0.5, 0.5},
         10.0,
         1200.0,
         6.44337597077e-6,
         8.99217011454e-6},
        {{0.014, 0.020}, Bingham{5.0, 0.5}, 10.0, 1000.0, 3.40114363783e-5, 9.93816963142e-5},
        {{0.014, 0.020}, PowerLaw{0.5, 0.5}, 10.0, 1000.0, 2.68828799906e-5, 0.000111965347733},
        {{0.014, 0.020}, PowerLaw{0.5, 1.5}, 10.0, 1000.0, 3.67448274372e-5, 9.5119181705e-5}};
    for (const Expected& expected : cases) {
        const auto inertia = [&](TurningWall wall) {
            return response_of(expected.gap, expected.law, expected.density, expected.omega, wall)
                .inertia;
        };
        EXPECT_NEAR(inertia(TurningWall::inner) / expected.inner, 1.0, 1e-4)
            << laws::flow::name_of(expected.law);
        EXPECT_NEAR(inertia(TurningWall::outer) / expected.outer, 1.0, 1e-4)
            << laws::flow::name_of(expected.law);
    }
}

// Origin: the slowest mode decays with nu x^2 / R^2, x the first zero of
// J1(x) Y1(delta x) - J1(delta x) Y1(x): 3.196578380810635 at delta = 2 (mpmath); pi / width for a
// narrow gap.
TEST(GapResponse, decay_time_is_close_to_the_slowest_mode_of_a_newtonian_fluid) {
    const AnyFlowLaw law = laws::flow::Newtonian{1.0};
    const double wide = response_of({1.0, 2.0}, law, 1.0, 1.0, TurningWall::inner).decay_time;
    EXPECT_NEAR(wide * 3.196578380810635 * 3.196578380810635, 1.0, 0.04);
    const double narrow = response_of({1.0, 1.001}, law, 1.0, 1.0, TurningWall::inner).decay_time;
    EXPECT_NEAR(narrow * std::numbers::pi * std::numbers::pi / 1e-6, 1.0, 1e-6);
}

TEST(GapResponse, plane_gap_is_the_limit_of_a_narrow_annulus) {
    const double width = 1e-3;
    const AnyFlowLaw law = laws::flow::HerschelBulkley{1.0, 0.2, 0.7};
    const double radius = 1e3;
    const AnnularGap gap{radius, radius + width};
    const double rate = 30.0;
    const GapResponse annular =
        response_of(gap, law, 1000.0, rate * width / radius, TurningWall::inner);
    const GapResponse plane = plane_gap_response(width, law, 1000.0, rate);
    // Torque per length and angular acceleration against force per area and acceleration.
    const double scale = 2.0 * std::numbers::pi * radius * radius * radius;
    EXPECT_NEAR(annular.inertia / scale / plane.inertia, 1.0, 1e-5);
    EXPECT_NEAR(annular.decay_time / plane.decay_time, 1.0, 1e-5);
}

// Origin: direct sums with 30 digits (mpmath); 0.499 and 0.501 lie on the two sides of the change
// from Jacobi's form to the sum.
TEST(Disturbance, sums_equal_their_series_on_both_sides_of_the_switch) {
    struct Expected {
        double x;
        double jump;
        double kink;
    };
    for (const auto& [x, jump, kink] :
         std::vector<Expected>{{0.01, 8.3622692545275801, 0.1722453850905516},
                               {0.3, 1.1180215937964327, 0.82081295627784977},
                               {0.499, 0.75456934101511556, 1.0025601960454489},
                               {0.501, 0.75206270699005224, 1.0040668255868111},
                               {1.0, 0.38631860241332608, 1.2724619967201426},
                               {5.0, 0.0067379490602390896, 1.6381961193338526},
                               {20.0, 2.0611536224385578e-9, 1.6449340647870728}}) {
        EXPECT_NEAR(after_jump(x) / jump, 1.0, 2e-8) << x;
        EXPECT_NEAR(after_kink(x), kink, 1e-8) << x;
    }
    EXPECT_EQ(after_kink(0.0), 0.0);
}

} // namespace
} // namespace searle::solvers
