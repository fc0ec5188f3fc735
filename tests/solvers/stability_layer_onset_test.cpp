#include "solvers/stability/layer_onset.hpp"

#include "solvers/stability/onset_curve.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace searle::solvers::stability {
namespace {

using namespace laws::flow;
using radial::AnnularGap;

AnnularGap gap_of(double radius_ratio) { return {0.01, 0.01 * radius_ratio}; }

// Origin: DiPrima & Swinney 1981 (in Hydrodynamic Instabilities and the Transition to Turbulence,
// ed. Swinney & Gollub, chapter 6, table of critical values): R_bob / R_cup and Re_c, two decimals.
TEST(LayerOnset, newtonian_fluid_has_the_published_onset) {
    for (const auto& [ratio, reynolds] : std::vector<std::pair<double, double>>{{0.5, 68.19},
                                                                                {0.6, 71.72},
                                                                                {0.7, 79.49},
                                                                                {0.8, 94.73},
                                                                                {0.9, 131.61},
                                                                                {0.95, 184.99}}) {
        const LayerOnset found = layer_onset(gap_of(1.0 / ratio), Newtonian{0.02}, 3.0, 1e-6);
        EXPECT_NEAR(found.reynolds, reynolds, 0.006) << ratio;
    }
}

// Origin: taylor_threshold, whose own problem is in another form (one viscosity) with another basis
// and was compared with 30-digit collocation. Every law has a Newtonian limit.
TEST(LayerOnset, laws_in_their_newtonian_limit_meet_the_newtonian_threshold) {
    for (const double ratio : {0.05, 0.5, 0.7, 0.883, 0.95, 0.9999}) {
        const TaylorThreshold exact = taylor_threshold(1.0 / ratio - 1.0);
        for (const AnyFlowLaw& law : std::vector<AnyFlowLaw>{
                 Newtonian{0.3}, PowerLaw{0.3, 1.0}, Bingham{0.0, 0.3},
                 HerschelBulkley{0.0, 0.3, 1.0}, Casson{0.0, 0.3},
                 CarreauYasuda{0.3, 0.001, 1.0, 1.0, 2.0}, Cross{0.3, 0.3, 1.0, 0.5}}) {
            const LayerOnset found = layer_onset(gap_of(1.0 / ratio), law, 7.0, 1e-8);
            EXPECT_NEAR(found.reynolds / exact.reynolds, 1.0, 1e-8) << ratio << name_of(law);
            EXPECT_NEAR(found.wave_number, exact.wave_number, 1e-4) << ratio << name_of(law);
        }
    }
}

// Origin: an independent program for power-law fluids (Legendre-Galerkin in numpy): the critical Re
// with the viscosity at the bob over that of a Newtonian fluid, three digits.
TEST(LayerOnset, power_law_fluids_agree_with_an_independent_program) {
    struct Known {
        double radius_ratio;
        double flow_index;
        double threshold;
    };
    for (const auto& [radius_ratio, flow_index, threshold] :
         std::vector<Known>{{1.0005, 0.9, 0.974},
                            {1.0005, 0.5, 0.856},
                            {1.0005, 0.3, 0.780},
                            {1.0005, 1.5, 1.115},
                            {1.0714, 0.7, 0.949},
                            {1.0714, 0.3, 0.930},
                            {1.0714, 1.5, 1.087},
                            {1.2, 0.5, 1.050},
                            {1.2, 1.5, 1.040},
                            {2.0, 0.5, 1.913},
                            {2.0, 1.5, 0.828}}) {
        const LayerOnset found =
            layer_onset(gap_of(radius_ratio), PowerLaw{0.01, flow_index}, 10.0, 1e-6);
        EXPECT_NEAR(found.reynolds / taylor_threshold(radius_ratio - 1.0).reynolds, threshold, 5e-4)
            << radius_ratio << ' ' << flow_index;
    }
}

struct Scene {
    const char* name;
    double radius_ratio;
    AnyFlowLaw law;
    double speed;
};

// Galerkin with functions that have the exact behaviour at both ends: the error falls at least
// exponentially. Resolutions in ratio, errors against 60 modes; rounding shows at 1e-10.
TEST(LayerOnset, error_falls_exponentially_with_the_number_of_modes) {
    for (const auto& [name, radius_ratio, law, speed] : std::vector<Scene>{
             {"power law", 1.07, PowerLaw{0.5, 0.4}, 20.0},
             {"power law, wide", 2.0, PowerLaw{0.5, 0.2}, 20.0},
             {"thickening", 2.0, PowerLaw{0.05, 1.8}, 20.0},
             {"Carreau", 2.0, CarreauYasuda{0.5, 0.001, 0.3, 0.4, 2.0}, 20.0},
             {"Bingham, a plug", 2.0, Bingham{5.0, 0.05}, 20.0},
             {"Herschel-Bulkley, a plug", 1.5, HerschelBulkley{20.0, 2.0, 0.3}, 10.0},
             {"Casson, a plug", 1.5, Casson{20.0, 0.05}, 10.0}}) {
        const auto density = [&, gap = gap_of(radius_ratio), &law = law, speed = speed](int modes) {
            return layer_onset_with_modes(gap, law, speed, modes).critical_density;
        };
        const double exact = density(60);
        const auto error = [&](int modes) { return std::abs(density(modes) / exact - 1.0); };
        const double rounding = 1e-10;
        const double four = error(4);
        const double eight = error(8);
        const double twelve = error(12);
        EXPECT_GT(four, 1e-6) << name << ": the coarse resolution must have an error to lose";
        EXPECT_LT(eight, std::max(rounding, 0.1 * four)) << name;
        EXPECT_LT(twelve, std::max(rounding, 0.1 * eight)) << name;
        EXPECT_LT(error(20), 1e-7) << name;
        EXPECT_LT(error(40), 1e-9) << name;
    }
}

// A power law has no scale: its critical Re with the viscosity at the bob depends on n and the
// radius ratio alone, not on speed, consistency or size.
TEST(LayerOnset, power_law_onset_depends_on_index_and_radius_ratio_alone) {
    const double one = layer_onset({0.01, 0.012}, PowerLaw{0.5, 0.4}, 20.0, 1e-8).reynolds;
    const double other = layer_onset({1.0, 1.2}, PowerLaw{3e4, 0.4}, 1e-3, 1e-8).reynolds;
    EXPECT_NEAR(one / other, 1.0, 1e-8);
}

AnyFlowLaw random_law(std::mt19937& numbers) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(numbers);
    };
    const auto spread = [&](double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    };
    switch (std::uniform_int_distribution(0, 5)(numbers)) {
    case 0:
        return PowerLaw{spread(1e-3, 10.0), uniform(0.2, 1.8)};
    case 1:
        return HerschelBulkley{spread(1e-2, 1e4), spread(1e-3, 10.0), uniform(0.2, 1.8)};
    case 2:
        return Casson{spread(1e-2, 1e3), spread(1e-3, 1.0)};
    case 3:
        return CarreauYasuda{spread(1e-2, 10.0), spread(1e-4, 1e-2), spread(1e-3, 10.0),
                             uniform(0.2, 0.9), uniform(0.5, 2.0)};
    case 4:
        return Cross{spread(1e-2, 10.0), spread(1e-4, 1e-2), spread(1e-3, 10.0), uniform(0.2, 0.9)};
    default:
        return Bingham{spread(1e-2, 1e4), spread(1e-3, 1.0)};
    }
}

// Energy theory bounds from below what linear theory can have: at the linear onset the ratio of
// energy drawn to energy dissipated must not be less than 1. 300 random scenes.
TEST(LayerOnset, energy_method_never_excludes_a_linear_onset) {
    std::mt19937 numbers(7);
    double closest = 1e9;
    for (int scene = 0; scene < 300; ++scene) {
        const AnyFlowLaw law = random_law(numbers);
        const double relative_gap =
            std::exp(std::uniform_real_distribution(std::log(0.005), std::log(2.0))(numbers));
        const double speed =
            std::exp(std::uniform_real_distribution(std::log(0.01), std::log(100.0))(numbers));
        const AnnularGap gap = gap_of(1.0 + relative_gap);
        const LayerOnset found = layer_onset(gap, law, speed, 1e-4);
        EXPECT_LT(found.relative_error, 1e-4) << name_of(law) << ' ' << relative_gap;
        const double ratio = energy_ratio(gap, law, speed, found.critical_density);
        closest = std::min(closest, ratio);
        EXPECT_GT(ratio, 1.0) << name_of(law) << ' ' << relative_gap;
    }
    EXPECT_GT(closest, 1.0);
}

// Between the Chebyshev points the curve is held against the eigenvalue problem itself.
TEST(OnsetCurve, agrees_with_the_eigenvalue_problem_at_every_speed) {
    const AnnularGap gap = gap_of(1.5);
    for (const AnyFlowLaw& law :
         std::vector<AnyFlowLaw>{PowerLaw{0.5, 0.4}, CarreauYasuda{0.5, 0.001, 0.3, 0.4, 2.0},
                                 HerschelBulkley{20.0, 2.0, 0.5}, Casson{2.0, 0.02}}) {
        const OnsetCurve curve(gap, law, 0.5, 500.0, 1e-4);
        EXPECT_LE(curve.solved(), 17);
        for (double speed = 0.5; speed <= 500.0; speed *= 1.7) {
            const double exact = layer_onset(gap, law, speed, 1e-8).reynolds;
            EXPECT_NEAR(curve.critical_reynolds(speed) / exact, 1.0,
                        2.0 * curve.relative_error() + 1e-6)
                << name_of(law) << ' ' << speed;
        }
    }
}

TEST(CriticalSpeed, is_where_the_density_is_the_critical_one) {
    const AnnularGap gap = gap_of(1.2);
    for (const AnyFlowLaw& law :
         std::vector<AnyFlowLaw>{PowerLaw{0.05, 0.6}, CarreauYasuda{0.05, 0.001, 0.3, 0.4, 2.0},
                                 HerschelBulkley{2.0, 0.05, 0.7}}) {
        for (const double guess : {5.0, 100.0, 2000.0}) {
            const auto found = critical_speed(gap, law, 1000.0, guess, 1e-8);
            ASSERT_TRUE(found) << name_of(law);
            EXPECT_NEAR(found->onset.critical_density, 1000.0, 0.01) << name_of(law);
        }
    }
    // Newtonian: omega = Re_c nu / (R d).
    const auto water = critical_speed({0.014, 0.015}, Newtonian{1e-3}, 1000.0, 1.0, 1e-8);
    ASSERT_TRUE(water);
    EXPECT_NEAR(water->speed, 160.50432850405 * 1e-6 / (0.014 * 0.001), 2e-5 * water->speed);
}

// With n = 2 density over critical density does not depend on the speed at all.
TEST(CriticalSpeed, is_absent_for_a_fluid_that_thickens_as_fast_as_it_turns) {
    EXPECT_FALSE(critical_speed(gap_of(1.2), PowerLaw{0.05, 2.0}, 10.0, 1.0, 1e-4));
}

TEST(LayerOnset, impossible_arguments_are_refused) {
    EXPECT_THROW((void)layer_onset({0.01, 0.01}, Newtonian{1.0}, 1.0, 1e-4), std::invalid_argument);
    EXPECT_THROW((void)layer_onset(gap_of(1.1), Newtonian{1.0}, 0.0, 1e-4), std::invalid_argument);
    EXPECT_THROW((void)layer_onset_with_modes(gap_of(1.1), Newtonian{1.0}, 1.0, 3),
                 std::invalid_argument);
}

} // namespace
} // namespace searle::solvers::stability
