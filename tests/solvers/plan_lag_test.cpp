#include "rheometry/schedule.hpp"
#include "solvers/plan.hpp"
#include "solvers/plan_lag.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace searle::solvers {
namespace {

using rheometry::SpeedHistory;

const Fluid water{laws::flow::Newtonian{1.0016e-3}, 998.2};
const geometry::Instrument narrow_gap = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
const geometry::Instrument box = geometry::Box{0.001, 0.02, 0.03};

std::vector<LagForecast> forecast_of(const geometry::Instrument& instrument, const Fluid& fluid,
                                     const SpeedHistory& history) {
    std::vector<double> speeds{history.initial_speed};
    for (const SpeedHistory::Piece& piece : history.pieces) {
        speeds.push_back(piece.start_speed);
        speeds.push_back(piece.end_speed);
    }
    for (const double time : history.row_times) {
        speeds.push_back(history.speed_at(time));
    }
    SteadyCurve curve(instrument, fluid, speeds);
    return forecast_lag(history, curve);
}

/// Measured over steady stress of a row whose inertia has the sign of its stress.
double stress_ratio(const LagForecast& forecast) { return 1.0 / (1.0 - forecast.share); }

// Origin: physics notes, section 2: exact eta_app / eta of the ramp 0 -> 100 1/s (bob wall) in 35
// s, 14/15 mm, rho 998.2, mu 1.0016e-3. The forecast has the exact lag and a plane gap's transient.
TEST(LagForecast, water_ramp_meets_the_exact_apparent_viscosity) {
    SpeedHistory history;
    history.pieces = {
        {.start_time = 0.0, .end_time = 35.0, .start_speed = 0.0, .end_speed = 6.444}};
    history.row_times = {0.1, 0.5, 1.0, 5.0, 10.0, 35.0};
    const std::vector<double> exact{3.310969, 1.596579, 1.299566, 1.059915, 1.029957, 1.008559};
    const std::vector<double> tolerance{1e-3, 1e-5, 1e-6, 1e-6, 1e-6, 1e-6};
    const std::vector<LagForecast> forecasts = forecast_of(narrow_gap, water, history);
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(stress_ratio(forecasts[i]), exact[i], tolerance[i]) << history.row_times[i];
    }
}

// Origin: the Fourier series of plane Couette flow started suddenly: wall stress over the steady
// one 1 + 2 sum exp(-n^2 pi^2 nu t / h^2); at t = 0.2 and 0.4 of h^2 /
// nu: 1.27856699942, 1.03859288311 (mpmath, 30 digits).
TEST(LagForecast, plane_gap_after_a_jump_is_exact) {
    const double diffusion_time = 0.001 * 0.001 * 998.2 / 1.0016e-3;
    SpeedHistory history;
    history.pieces = {{.start_time = 0.0, .end_time = 5.0, .start_speed = 0.03, .end_speed = 0.03}};
    history.row_times = {0.2 * diffusion_time, 0.4 * diffusion_time};
    const std::vector<LagForecast> forecasts = forecast_of(box, water, history);
    EXPECT_NEAR(stress_ratio(forecasts[0]), 1.27856699942, 1e-10);
    EXPECT_NEAR(stress_ratio(forecasts[1]), 1.03859288311, 1e-10);
}

// A ramp cut into many equal pieces is the same ramp; beyond the pieces that a row remembers one by
// one it may only be forecast larger.
TEST(LagForecast, a_ramp_in_many_pieces_is_the_same_ramp) {
    SpeedHistory whole;
    whole.pieces = {{.start_time = 0.0, .end_time = 4.0, .start_speed = 0.0, .end_speed = 8.0}};
    for (int k = 1; k <= 400; ++k) {
        whole.row_times.push_back(0.01 * k);
    }
    whole.row_times.back() = 4.0;
    SpeedHistory cut = whole;
    cut.pieces.clear();
    for (int k = 0; k < 16; ++k) {
        cut.pieces.push_back({.start_time = 0.25 * k,
                              .end_time = 0.25 * (k + 1),
                              .start_speed = 0.5 * k,
                              .end_speed = 0.5 * (k + 1)});
    }
    const std::vector<LagForecast> expected = forecast_of(narrow_gap, water, whole);
    const std::vector<LagForecast> found = forecast_of(narrow_gap, water, cut);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(found[i].share, expected[i].share, 1e-9);
    }
    // 0.01 s pieces: a hundred of them within the fluid's memory.
    SpeedHistory fine = whole;
    fine.pieces.clear();
    for (int k = 0; k < 400; ++k) {
        fine.pieces.push_back({.start_time = 0.01 * k,
                               .end_time = 0.01 * (k + 1),
                               .start_speed = 0.02 * k,
                               .end_speed = 0.02 * (k + 1)});
    }
    const std::vector<LagForecast> bounded = forecast_of(narrow_gap, water, fine);
    for (std::size_t i = 1; i < expected.size(); ++i) {
        EXPECT_GE(bounded[i].share, expected[i].share * (1.0 - 1e-6)) << i;
    }
}

TEST(LagForecast, held_long_enough_nothing_is_left) {
    SpeedHistory history;
    history.pieces = {{.start_time = 0.0, .end_time = 30.0, .start_speed = 5.0, .end_speed = 5.0}};
    history.row_times = {30.0};
    EXPECT_LT(forecast_of(narrow_gap, water, history).front().largest, 1e-13);
}

TEST(LagForecast, a_steady_start_has_no_transient) {
    SpeedHistory history;
    history.initial_speed = 5.0;
    history.pieces = {{.start_time = 0.0, .end_time = 1.0, .start_speed = 5.0, .end_speed = 5.0}};
    history.row_times = {0.01};
    EXPECT_EQ(forecast_of(narrow_gap, water, history).front().share, 0.0);
}

// At rest the fluid still turns: all of the stress is inertia.
TEST(LagForecast, a_stop_leaves_only_inertia) {
    SpeedHistory history;
    history.initial_speed = 5.0;
    history.pieces = {{.start_time = 0.0, .end_time = 1.0, .start_speed = 0.0, .end_speed = 0.0}};
    history.row_times = {0.05};
    EXPECT_GT(forecast_of(narrow_gap, water, history).front().share, 0.999);
}

// A yield stress holds a fluid that was slowed down gently: its torque is open, whatever the time
// steps. After an abrupt stop it still turns.
TEST(LagForecast, a_yield_stress_holds_what_stops_gently) {
    const Fluid slurry{laws::flow::HerschelBulkley{5.0, 0.5, 0.5}, 1200.0};
    for (const bool gently : {true, false}) {
        SpeedHistory history;
        history.initial_speed = 5.0;
        history.pieces = {{.start_time = 0.0,
                           .end_time = 30.0,
                           .start_speed = 5.0,
                           .end_speed = gently ? 0.0 : 5.0},
                          {.start_time = 30.0, .end_time = 31.0}};
        history.row_times = {30.0, 30.0 + 1e-5};
        const std::vector<LagForecast> found = forecast_of(narrow_gap, slurry, history);
        EXPECT_EQ(found.back().largest == 0.0, gently);
    }
}

// Origin: the same Fourier series: 2 sum exp(-n^2 pi^2 nu t / h^2) must be the accuracy at that
// time.
TEST(SettlingTime, residual_of_a_plane_gap_is_the_accuracy) {
    for (const double accuracy : {1e-2, 1e-4, 1e-8}) {
        const double time = settling_time(box, water, 0.0, 0.02, accuracy);
        const double x = M_PI * M_PI * 1.0016e-3 / 998.2 / 1e-6 * time;
        EXPECT_NEAR(2.0 * (std::exp(-x) + std::exp(-4.0 * x)) / accuracy, 1.0, 1e-5);
    }
}

TEST(SettlingTime, nothing_to_wait_for_without_a_change) {
    EXPECT_EQ(settling_time(narrow_gap, water, 3.0, 3.0, 1e-3), 0.0);
    EXPECT_EQ(settling_time(narrow_gap, water, 0.0, 0.0, 1e-3), 0.0);
    EXPECT_EQ(settling_time(narrow_gap, water, 3.0, 3.0 * (1.0 + 1e-9), 1e-3), 0.0);
}

TEST(SettlingTime, jumps_to_and_from_rest_take_the_same_time) {
    EXPECT_NEAR(settling_time(narrow_gap, water, 0.0, 3.0, 1e-3),
                settling_time(narrow_gap, water, 3.0, 0.0, 1e-3), 1e-12);
}

TEST(SettlingTime, a_series_adds_its_steps) {
    const std::vector<double> speeds{1.0, 4.0, 4.0, 0.5};
    const std::vector<double> times = settling_times(narrow_gap, water, speeds, 1e-3);
    ASSERT_EQ(times.size(), 4u);
    EXPECT_NEAR(times[0], settling_time(narrow_gap, water, 0.0, 1.0, 1e-3), 1e-12);
    EXPECT_NEAR(times[1] - times[0], settling_time(narrow_gap, water, 1.0, 4.0, 1e-3), 1e-12);
    EXPECT_EQ(times[2], times[1]);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

} // namespace
} // namespace searle::solvers
