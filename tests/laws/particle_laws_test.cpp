#include "laws/colloid/dlvo.hpp"
#include "laws/contact/hertz.hpp"
#include "laws/contact/hooke.hpp"
#include "laws/contact/rayleigh_time.hpp"
#include "laws/drag/di_felice.hpp"
#include "laws/drag/ergun_wen_yu.hpp"
#include "laws/drag/stokes.hpp"
#include "laws/exponential.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace searle::laws {
namespace {

using Precise = boost::multiprecision::cpp_bin_float_50;

constexpr double kelvin_298 = 298.0 * colloid::boltzmann;

/// The zirconia of "Methodology for CFD-DEM modelling of particulate suspension rheology": 1.5 um
/// spheres, 32 mV, Debye length 10 nm.
template <class Layer>
colloid::Dlvo<Layer> zirconia(double hamaker) {
    colloid::Dlvo<Layer> dlvo;
    dlvo.attraction.hamaker = hamaker;
    dlvo.layer.permittivity = 80.1 * colloid::vacuum_permittivity;
    dlvo.layer.potential = 32e-3;
    dlvo.layer.inverse_thickness = 1e8;
    dlvo.minimum_separation = 0.3e-9;
    dlvo.cutoff = 100e-9;
    return dlvo;
}

/// -dE/dh from E at 50 digits, central difference of sixth order; its own error is below 1e-20.
template <class Energy>
double force_of(const Energy& energy, double distance) {
    const Precise h = distance;
    const Precise step = h * Precise("1e-6");
    const auto pair = [&](int k) -> Precise { return energy(h + k * step) - energy(h - k * step); };
    const Precise slope = (45 * pair(1) - 9 * pair(2) + pair(3)) / (60 * step);
    return static_cast<double>(-slope);
}

TEST(Hamaker, attraction_is_the_derivative_of_the_energy) {
    const colloid::Hamaker<double> law{6e-20};
    for (const double h : {1e-10, 3e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5})
        for (const double ratio : {0.01, 0.5, 1.0, 3.0}) {
            const double a = 0.75e-6;
            const double b = ratio * a;
            const double expected = force_of(
                [&](const Precise& d) { return law.energy(d, Precise(a), Precise(b)); }, h);
            EXPECT_NEAR(-law.attraction(h, a, b) / expected, 1.0, 4e-15) << h << ' ' << ratio;
        }
}

TEST(Hamaker, has_the_limits_of_touching_and_of_distant_spheres) {
    const colloid::Hamaker<double> law{6e-20};
    const double a = 0.75e-6;
    // Derjaguin: A a / (12 h^2), relative correction of order h ln h / a.
    EXPECT_NEAR(law.attraction(1e-14, a, a) / (6e-20 * a / (12.0 * 1e-28)), 1.0, 1e-6);
    // Point dipoles: E = -(16/9) A a^6 / r^6, so F = (32/3) A a^6 / r^7; correction (a/r)^2.
    const double r = 1e3 * a;
    EXPECT_NEAR(law.attraction(r - 2 * a, a, a) /
                    (32.0 / 3.0 * 6e-20 * std::pow(a, 6) / std::pow(r, 7)),
                1.0, 2e-5);
}

TEST(DoubleLayer, repulsion_is_the_derivative_of_the_energy) {
    const auto weak = zirconia<colloid::WeakOverlap>(0.0).layer;
    const auto constant = zirconia<colloid::ConstantPotential>(0.0).layer;
    const double a = 0.75e-6;
    const double b = 0.4e-6;
    const Precise kappa = 1e8;
    for (const double h : {0.0 + 1e-12, 1e-9, 1e-8, 5e-8, 1e-7}) {
        const double from_weak = force_of(
            [&](const Precise& d) -> Precise { return weak.prefactor(a, b) * exp(-kappa * d); }, h);
        EXPECT_NEAR(weak.repulsion(h, a, b) / from_weak, 1.0, 4e-15);
        const double from_constant = force_of(
            [&](const Precise& d) -> Precise {
                return constant.prefactor(a, b) * log(1 + exp(-kappa * d));
            },
            h);
        EXPECT_NEAR(constant.repulsion(h, a, b) / from_constant, 1.0, 4e-15);
    }
}

TEST(DoubleLayer, equal_spheres_have_the_familiar_prefactor) {
    const auto weak = zirconia<colloid::WeakOverlap>(0.0).layer;
    EXPECT_DOUBLE_EQ(weak.prefactor(1e-6, 1e-6),
                     2 * std::numbers::pi * weak.permittivity * 1e-6 * 32e-3 * 32e-3);
}

/// Table of physics.md section 4, recomputed independently of this code: barrier and secondary
/// minimum in kT at 298 K, largest repulsion over 6 pi mu a^2 shear rate at 180 1/s.
TEST(Dlvo, zirconia_has_the_tabulated_barriers) {
    struct Row {
        double hamaker, barrier, minimum, repulsion;
    };
    const double a = 0.75e-6;
    const double shear_force = 6 * std::numbers::pi * 1.0016e-3 * a * a * 180;
    for (const Row& row : {Row{1e-19, 222, -15.0, 34}, Row{6e-20, 342, -7.7, 50}}) {
        const auto curve = colloid::dlvo_curve(zirconia<colloid::WeakOverlap>(row.hamaker), a, a);
        EXPECT_NEAR(curve.barrier / kelvin_298, row.barrier, 0.5);
        EXPECT_NEAR(curve.secondary_minimum / kelvin_298, row.minimum, 0.05);
        EXPECT_NEAR(curve.largest_repulsion / shear_force, row.repulsion, 0.5);
    }
    for (const Row& row : {Row{1e-19, 136, -15.0, 20}, Row{6e-20, 224, -7.7, 29}}) {
        const auto curve =
            colloid::dlvo_curve(zirconia<colloid::ConstantPotential>(row.hamaker), a, a);
        EXPECT_NEAR(curve.barrier / kelvin_298, row.barrier, 0.5);
        EXPECT_NEAR(curve.secondary_minimum / kelvin_298, row.minimum, 0.05);
        EXPECT_NEAR(curve.largest_repulsion / shear_force, row.repulsion, 0.5);
    }
}

TEST(Dlvo, stays_at_its_value_below_the_minimum_separation) {
    const auto dlvo = zirconia<colloid::WeakOverlap>(6e-20);
    const double a = 0.75e-6;
    const double there = dlvo.repulsion(0.3e-9, a, a);
    EXPECT_EQ(dlvo.repulsion(0.0, a, a), there);
    EXPECT_EQ(dlvo.repulsion(-1e-8, a, a), there);
    EXPECT_NE(dlvo.repulsion(0.31e-9, a, a), there);
}

TEST(DebyeLength, of_one_millimole_is_that_of_the_textbook) {
    // 0.304 nm / sqrt(I in mol/l) in water at 25 degC (Israelachvili 2011, eq. 14.37): 9.6 nm.
    EXPECT_NEAR(colloid::debye_length(78.5, 298.15, 1.0), 9.61e-9, 0.02e-9);
}

TEST(Hooke, damping_ratio_gives_the_restitution_back) {
    for (const double e : {0.05, 0.3, 0.9, 0.999, 1.0}) {
        const double k = 1e-2;
        const double m = 5e-15;
        const double gamma = 2.0 * contact::damping_ratio(e) * std::sqrt(k * m);
        EXPECT_NEAR(contact::restitution_of(gamma, k, m), e, 1e-14);
    }
}

/// A sphere of R = 1 mm, G = 77 GPa, nu = 0.3 pressed onto its like by 1 um, worked by hand:
/// E* = 77e9 / 0.7 = 1.1e11 Pa, R* = 0.5 mm, a = sqrt(5e-4 1e-6) = 2.236068e-5 m,
/// F = 4/3 E* a overlap = 3.279567 N, k_t = 8 (77e9 / (2 1.7)) a = 4.051229e6 N/m.
TEST(Hertz, of_two_spheres_worked_by_hand) {
    const contact::Hertz law{.shear_modulus = 77e9, .poisson_ratio = 0.3};
    const contact::ContactSpring spring = law.at(1e-6, 5e-4, 1e-6);
    EXPECT_NEAR(spring.normal * 1e-6, 3.279567, 1e-6);
    EXPECT_NEAR(spring.tangential, 4.051229e6, 1.0);
    EXPECT_NEAR(law.overlap_under(3.279567, 5e-4), 1e-6, 1e-12);
    EXPECT_EQ(spring.damping, 0.0);
}

/// Mindlin 1949: the tangential stiffness over the slope of the normal force is
/// 2 (1 - nu) / (2 - nu), 0.823529 for nu = 0.3; the slope is the derivative of the force.
TEST(Hertz, stiffnesses_have_mindlins_ratio_and_the_slope_is_the_forces) {
    const contact::Hertz law{.shear_modulus = 1e7, .poisson_ratio = 0.3};
    for (const double overlap : {1e-9, 1e-7, 1e-5}) {
        const contact::ContactSpring spring = law.at(overlap, 1e-4, 1e-9);
        EXPECT_NEAR(spring.tangential / spring.slope, 0.8235294117647058, 1e-12);
        const auto force = [&](double at) { return law.at(at, 1e-4, 1e-9).normal * at; };
        const double probe = 1e-4 * overlap;
        EXPECT_NEAR((force(overlap + probe) - force(overlap - probe)) / (2.0 * probe) /
                        spring.slope,
                    1.0, 1e-8);
    }
    EXPECT_EQ(law.at(0.0, 1e-4, 1e-9).normal, 0.0);
    EXPECT_EQ(law.at(-1e-9, 1e-4, 1e-9).slope, 0.0);
}

TEST(RayleighTime, of_zirconia_is_that_of_the_paper) {
    // physics.md section 4: E 200 GPa gives 6.9e-10 s; G = E / (2 (1 + nu)), nu = 0.3.
    EXPECT_NEAR(contact::rayleigh_time(0.75e-6, 5700, 200e9 / 2.6, 0.3), 6.9e-10, 0.05e-10);
}

TEST(DiFelice, has_its_finite_limit_at_rest) {
    const drag::DiFelice law{1.0016e-3, 998.2};
    for (const double eps : {1.0, 0.95, 0.5}) {
        const double limit = 5.76 * std::numbers::pi * 1.0016e-3 * 0.75e-6 * std::pow(eps, -2.7);
        EXPECT_NEAR(law.coefficient(0.75e-6, 0.0, eps) / limit, 1.0, 1e-14);
        // Approached as the square root of Re: 2 * 0.63 / 4.8 sqrt(Re).
        const double slip = 1e-9;
        const double reynolds = 998.2 * 1.5e-6 * eps * slip / 1.0016e-3;
        EXPECT_NEAR(law.coefficient(0.75e-6, slip, eps) / limit - 1.0,
                    2 * 0.63 / 4.8 * std::sqrt(reynolds), 1e-9);
    }
    const drag::Stokes stokes{1.0016e-3, 998.2};
    EXPECT_NEAR(law.coefficient(0.75e-6, 0.0, 1.0) / stokes.coefficient(0.75e-6, 0.0, 1.0), 0.96,
                1e-14);
}

TEST(DiFelice, is_the_formula_as_published) {
    const double mu = 1e-3, rho = 1000, r = 5e-4, eps = 0.7, slip = 0.1;
    const double re = rho * 2 * r * eps * slip / mu;
    const double cd = std::pow(0.63 + 4.8 / std::sqrt(re), 2);
    const double chi = 3.7 - 0.65 * std::exp(-std::pow(1.5 - std::log10(re), 2) / 2);
    const double force =
        0.5 * cd * rho * std::numbers::pi * r * r * slip * slip * std::pow(eps, 2 - chi);
    EXPECT_NEAR(drag::DiFelice({mu, rho}).coefficient(r, slip, eps) * slip / force, 1.0, 1e-13);
}

TEST(ErgunWenYu, ends_in_stokes_and_jumps_at_four_fifths) {
    const drag::ErgunWenYu law{1e-3, 1000};
    const double stokes = 6 * std::numbers::pi * 1e-3 * 1e-6;
    EXPECT_NEAR(law.coefficient(1e-6, 1e-12, 1.0) / stokes, 1.0, 1e-5);
    // Creeping: Ergun 150 * 0.2 / 0.8 / 18 = 2.0833; Wen-Yu 0.8^-2.65 = 1.8064 times Stokes.
    EXPECT_NEAR(law.coefficient(1e-6, 0.0, 0.8) / stokes, 150 * 0.2 / 0.8 / 18, 1e-10);
    EXPECT_NEAR(law.coefficient(1e-6, 0.0, 0.8 + 1e-12) / stokes, std::pow(0.8, -2.65), 1e-9);
}

TEST(Exponential, is_that_of_fifty_digits_within_three_units_of_the_seventeenth) {
    for (int k = -70800; k <= 70900; ++k) {
        const double x = 0.01 * k * (1.0 + 1e-9 * k);
        if (x < -708.0 || x > 709.0)
            continue;
        const Precise exact = exp(Precise(x));
        ASSERT_LT(static_cast<double>(abs(Precise(exponential(x)) / exact - 1)), 3e-16) << x;
    }
    EXPECT_EQ(exponential(0.0), 1.0);
    EXPECT_EQ(exponential(-1e9), exponential(-708.0));
    EXPECT_TRUE(std::isnan(exponential(std::numeric_limits<double>::quiet_NaN())));
}

} // namespace
} // namespace searle::laws
