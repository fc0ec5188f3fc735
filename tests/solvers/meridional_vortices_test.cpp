#include "solvers/meridional/flow_stability.hpp"
#include "solvers/meridional/flow_stepper.hpp"
#include "solvers/meridional/steady_vortices.hpp"
#include "solvers/meridional/vortex_cell.hpp"
#include "solvers/meridional/vortex_run.hpp"
#include "solvers/stability/taylor_threshold.hpp"
#include "tests/solvers/vortex_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace searle::solvers::meridional {
namespace {

VortexCell critical_cell(double gap) {
    return cell_of(gap, stability::taylor_threshold(gap).wave_number);
}

double growth_in_time(double gap, double gap_reynolds, const CellResolution& resolution) {
    const UnitViscosity law;
    return vortex_growth(critical_cell(gap), {law, gap_reynolds / gap}, gap * gap_reynolds,
                         resolution);
}

/// Where the growth vanishes, between 1 % below and above the linear theory's onset.
double onset_in_time(double gap, const CellResolution& resolution) {
    const double expected = stability::taylor_threshold(gap).reynolds;
    return expected *
           where_growth_vanishes(
               [&](double share) { return growth_in_time(gap, share * expected, resolution); },
               0.01);
}

/// The linear theory (stability/, itself held to published values: 68.1863, 118.1571, 184.9856 of
/// physics.md section 2) and the flow in time share no equation and no discretisation.
TEST(TaylorOnset, time_steps_find_the_onset_of_linear_theory_at_three_radius_ratios) {
    for (const double radius_ratio : {0.5, 0.875, 0.95}) {
        const double gap = 1.0 / radius_ratio - 1.0;
        const double expected = stability::taylor_threshold(gap).reynolds;
        std::vector<double> errors;
        for (const int degree : {4, 6, 8}) {
            errors.push_back(std::abs(
                onset_in_time(gap, {.degree = degree, .columns = 1, .rows = 1}) / expected - 1.0));
        }
        EXPECT_GT(errors[0], 4.0 * errors[1]) << radius_ratio;
        // The chord of the growth over +-1 % misses its curvature: 6e-6.
        EXPECT_LT(errors[2], 1e-5) << radius_ratio;
    }
}

TEST(FlowStability, arnoldi_and_time_steps_give_the_same_growth) {
    const double gap = 1.0 / 0.875 - 1.0;
    const CellResolution resolution{.degree = 8, .columns = 1, .rows = 1};
    const double reynolds = 1.01 * stability::taylor_threshold(gap).reynolds;
    const auto level = cell_level(critical_cell(gap), resolution);
    const UnitViscosity law;
    ASSERT_TRUE(level->solve_creeping(law, 1e-14));
    const LeadingDisturbance leading = leading_disturbance(*level, {law, reynolds / gap}, {}, 40);
    EXPECT_EQ(leading.rate.imag(), 0.0);
    EXPECT_NEAR(leading.rate.real() * gap * reynolds, growth_in_time(gap, reynolds, resolution),
                1e-5);
}

constexpr double density = 998.2;
const laws::flow::AnyFlowLaw water = laws::flow::Newtonian{1.0034e-6 * density};
const radial::AnnularGap wide_gap{0.014, 0.016};
constexpr double rate_per_speed = 2.0 / (1.0 - (14.0 * 14.0) / (16.0 * 16.0)); // at the bob's wall

double critical_wavelength() {
    return 2.0 * critical_cell(wide_gap.width() / wide_gap.inner_radius).height *
           wide_gap.inner_radius;
}

/// peers.md: OpenFOAM's coarse figures after 20 s are 1.33 at 42 1/s and 1.89 at 60 1/s.
TEST(SteadyVortices, torque_of_the_wide_gap_is_mesh_converged_and_near_a_peers) {
    SteadyVortices coarse(wide_gap, critical_wavelength(), water, density);
    SteadyVortices fine(wide_gap, critical_wavelength(), water, density);
    for (const auto& [rate, peer] : {std::pair{42.0, 1.33}, std::pair{60.0, 1.89}}) {
        const InertiaFactor first = coarse.at(rate / rate_per_speed, 1e-3);
        const InertiaFactor best = fine.at(rate / rate_per_speed, 1e-5);
        EXPECT_TRUE(first.reached);
        EXPECT_TRUE(best.reached);
        EXPECT_LE(std::abs(first.factor - best.factor),
                  (first.relative_error + best.relative_error) * best.factor);
        EXPECT_NEAR(best.factor, peer, 0.02 * peer);
    }
}

/// The branch leaves the laminar one at the onset of linear theory, with a finite slope: weakly
/// nonlinear theory has torque - 1 ~ Re / Re_c - 1 (Davey 1962, J. Fluid Mech. 14, 336).
TEST(SteadyVortices, torque_grows_linearly_from_the_onset) {
    const double gap = wide_gap.width() / wide_gap.inner_radius;
    const double onset = stability::taylor_threshold(gap).reynolds * 1.0034e-6 /
                         (wide_gap.inner_radius * wide_gap.width());
    SteadyVortices vortices(wide_gap, critical_wavelength(), water, density);
    EXPECT_EQ(vortices.at(0.998 * onset, 1e-5).factor, 1.0);
    const double one = vortices.at(1.005 * onset, 1e-5).factor - 1.0;
    const double two = vortices.at(1.010 * onset, 1e-5).factor - 1.0;
    EXPECT_GT(one, 0.0);
    EXPECT_NEAR(two / one, 2.0, 0.03);
}

std::vector<double> asked(const rheometry::SpeedHistory& history) {
    return std::vector<double>(history.row_times.size(), 1e-3);
}

/// A hold past the onset: vortices that grew from a small unevenness carry the torque of the steady
/// ones.
TEST(VortexRun, grows_into_the_steady_vortices) {
    const double speed = 60.0 / rate_per_speed;
    rheometry::SpeedHistory hold;
    hold.pieces = {{0.0, 1.0, 0.0, speed}, {1.0, 60.0, speed, speed}};
    hold.row_times = {0.5, 2.0, 60.0};
    const VortexRun run =
        vortex_run(wide_gap, critical_wavelength(), water, density, 1e-4, hold, asked(hold));
    ASSERT_TRUE(run.reached);
    SteadyVortices vortices(wide_gap, critical_wavelength(), water, density);
    const double laminar = radial::steady_gap_flow(wide_gap, water, speed).torque_per_length;
    EXPECT_NEAR(run.torque[2] / laminar, vortices.at(speed, 1e-4).factor, 2e-3);
}

/// The unevenness sets when vortices show, not how strong they get.
TEST(VortexRun, smaller_disturbances_show_later_and_end_alike) {
    // A tenth past the onset disturbances grow e-fold in 1.5 s.
    const double speed = 40.0 / rate_per_speed;
    rheometry::SpeedHistory hold;
    hold.pieces = {{0.0, 120.0, speed, speed}};
    hold.row_times = {12.0, 120.0};
    const auto torques = [&](double disturbance) {
        return vortex_run(wide_gap, critical_wavelength(), water, density, disturbance, hold,
                          asked(hold))
            .torque;
    };
    const std::vector<double> large = torques(1e-3);
    const std::vector<double> small = torques(1e-6);
    EXPECT_GT(large[0], 1.05 * small[0]);
    EXPECT_NEAR(large[1] / small[1], 1.0, 2e-3);
}

} // namespace
} // namespace searle::solvers::meridional
