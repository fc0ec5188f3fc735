#include "solvers/radial/transient_levels.hpp"
#include "verification/regularised_finite_volumes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::solvers::radial {
namespace {

struct Comparison {
    const char* name;
    double inner, outer, density;
    laws::flow::HerschelBulkley law;
    double speed, duration;
    bool there_and_back;
};

// Three scenes in which the inertia carries a good part of the stress and the plug moves.
constexpr Comparison comparisons[] = {
    {"Bingham ramp, wide gap", 0.010, 0.015, 1000.0, {1.0, 0.05, 1.0}, 20.0, 0.5, false},
    {"Herschel-Bulkley ramp", 0.014, 0.016, 1000.0, {2.0, 0.2, 0.5}, 30.0, 0.05, false},
    {"Herschel-Bulkley up and down", 0.010, 0.014, 1000.0, {2.0, 0.1, 0.7}, 20.0, 0.4, true}};

// The reference is extrapolated in its step (first order); what is left of its cells and its
// regularisation falls as both are refined, and the difference from the solver has to fall with it.
TEST(IndependentMethod, regularised_finite_volumes_tend_to_the_solver_s_torque) {
    for (const Comparison& each : comparisons) {
        SCOPED_TRACE(each.name);
        rheometry::SpeedHistory history;
        const double middle = each.duration / 2;
        if (each.there_and_back) {
            history.pieces = {{0.0, middle, 0.0, each.speed},
                              {middle, each.duration, each.speed, 0.0}};
        } else {
            history.pieces = {{0.0, each.duration, 0.0, each.speed}};
        }
        history.row_times = {0.25 * each.duration, 0.5 * each.duration, 0.75 * each.duration};
        const std::vector<RotorGap> gap{
            {{.planar = false, .inner = each.inner, .outer = each.outer, .density = each.density},
             -1.0}};
        const TransientTorque solved = solve_levels(gap, each.law, history, 1e-5, {});
        ASSERT_TRUE(solved.reached);

        const verification::FiniteVolumeScene scene{
            each.inner, each.outer, each.density, each.law,
            [&](double time) { return history.speed_at(std::min(time, each.duration)); }};
        const double typical_rate = each.speed * each.inner / (each.outer - each.inner);
        std::vector<double> difference;
        for (const int level : {0, 1, 2}) {
            const int cells = 50 << level;
            const double step = each.duration / (200 << level);
            const double e = 8e-3 * typical_rate * std::pow(0.5, level);
            const auto coarse =
                verification::regularised_wall_stress(scene, history.row_times, cells, step, e);
            const auto fine =
                verification::regularised_wall_stress(scene, history.row_times, cells, step / 2, e);
            double worst = 0.0;
            for (std::size_t k = 0; k < fine.size(); ++k) {
                const double extrapolated = 2.0 * fine[k] - coarse[k];
                const double stress = solved.torque[k] / (each.inner * each.inner);
                worst = std::max(worst, std::abs(extrapolated / stress - 1.0));
            }
            difference.push_back(worst);
        }
        EXPECT_LT(difference[1], 0.65 * difference[0]) << difference[0] << ' ' << difference[1];
        EXPECT_LT(difference[2], 0.65 * difference[1]) << difference[1] << ' ' << difference[2];
        // First order in the regularisation dominates: a further halving would halve it again.
        EXPECT_LT(difference[2], 2e-3);
    }
}

} // namespace
} // namespace searle::solvers::radial
