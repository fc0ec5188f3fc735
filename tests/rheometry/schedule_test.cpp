#include "rheometry/schedule.hpp"

#include <gtest/gtest.h>
#include <stdexcept>
#include <variant>

namespace searle::rheometry {
namespace {

// A conversion of the test's own, with a factor that binary numbers hold exactly: a rate of 4 1/s
// is a speed of 1 rad/s.
constexpr Conversion four_per_radian{.definition = RateDefinition::bob_wall,
                                     .end_factor = 1.0,
                                     .stress_per_torque = 1.0,
                                     .rate_per_speed = 4.0};

ProtocolSpeed rate(double value) { return {value, SpeedKind::shear_rate}; }
ProtocolSpeed drive(double value) { return {value, SpeedKind::drive}; }

SpeedHistory history_of(const Protocol& protocol) {
    return std::get<SpeedHistory>(schedule(protocol, four_per_radian));
}

TEST(Schedule, ramp_has_its_rows_at_multiples_of_duration_over_points) {
    const SpeedHistory history = history_of(
        {.program = Ramp{.from = rate(0.0), .to = rate(100.0), .duration = 35.0, .points = 100}});
    ASSERT_EQ(history.row_times.size(), 100u);
    for (int k = 1; k <= 100; ++k) {
        const double time = history.row_times[static_cast<std::size_t>(k - 1)];
        EXPECT_DOUBLE_EQ(time, 0.35 * k);
        EXPECT_NEAR(history.speed_at(time), 0.25 * k, 1e-13);
    }
    EXPECT_EQ(history.row_times.back(), 35.0);
    EXPECT_EQ(history.speed_at(35.0), 25.0);
    EXPECT_EQ(history.speed_at(0.0), 0.0);
    EXPECT_NEAR(history.acceleration_at(20.0), 25.0 / 35.0, 1e-15);
    EXPECT_EQ(history.duration(), 35.0);
}

// 0.1 * 3 / 3 and the like are not 0.1 in binary: the last row must not leave its piece.
TEST(Schedule, last_row_of_every_piece_falls_exactly_on_its_end) {
    Segments program;
    for (int i = 1; i <= 60; ++i) {
        program.segments.push_back({.to = rate(i), .duration = 0.1 * i, .points = 3 + i % 7});
    }
    const SpeedHistory history = history_of({.program = program});
    std::size_t row = 0;
    for (std::size_t i = 0; i < program.segments.size(); ++i) {
        row += static_cast<std::size_t>(program.segments[i].points);
        EXPECT_EQ(history.row_times[row - 1], history.pieces[i].end_time);
    }
    EXPECT_EQ(row, history.row_times.size());
    for (std::size_t i = 1; i < history.row_times.size(); ++i) {
        EXPECT_LT(history.row_times[i - 1], history.row_times[i]);
    }
}

TEST(Schedule, start_state_decides_what_the_drive_did_before_a_ramp) {
    const Ramp ramp{.from = drive(3.0), .to = drive(7.0), .duration = 2.0, .points = 4};
    const SpeedHistory held = history_of({.program = ramp, .start = StartState::steady});
    EXPECT_EQ(held.initial_speed, 3.0);
    EXPECT_EQ(held.pieces.front().start_speed, 3.0);
    const SpeedHistory jumped = history_of({.program = ramp, .start = StartState::rest});
    EXPECT_EQ(jumped.initial_speed, 0.0);
    EXPECT_EQ(jumped.pieces.front().start_speed, 3.0);
}

TEST(Schedule, drive_speeds_bypass_the_conversion_and_rates_do_not) {
    const SpeedHistory history = history_of(
        {.program = Ramp{.from = drive(8.0), .to = rate(8.0), .duration = 1.0, .points = 1}});
    EXPECT_EQ(history.pieces.front().start_speed, 8.0);
    EXPECT_EQ(history.pieces.front().end_speed, 2.0);
}

TEST(Schedule, held_steps_jump_at_their_start_and_are_read_at_their_end) {
    const SpeedHistory history =
        history_of({.program = Steps{.speeds = {rate(4.0), rate(40.0), rate(-4.0)}, .hold = 10.0}});
    EXPECT_EQ(history.initial_speed, 0.0);
    ASSERT_EQ(history.pieces.size(), 3u);
    EXPECT_EQ(history.row_times, (std::vector<double>{10.0, 20.0, 30.0}));
    EXPECT_EQ(history.speed_at(10.0), 1.0);
    EXPECT_EQ(history.speed_at(10.0 + 1e-9), 10.0);
    EXPECT_EQ(history.speed_at(30.0), -1.0);
    EXPECT_EQ(history.acceleration_at(15.0), 0.0);
}

TEST(Schedule, many_short_holds_do_not_drift) {
    Steps steps{.speeds = std::vector<ProtocolSpeed>(100000, rate(1.0)), .hold = 0.1};
    const SpeedHistory history = history_of({.program = steps});
    EXPECT_EQ(history.duration(), 0.1 * 100000.0);
    EXPECT_EQ(history.row_times[29999], 0.1 * 30000.0);
}

TEST(Schedule, steps_without_a_hold_are_a_steady_series) {
    const auto series =
        schedule({.program = Steps{.speeds = {rate(4.0), drive(5.0), rate(0.0)}, .hold = {}}},
                 four_per_radian);
    EXPECT_EQ(std::get<SteadySpeeds>(series).speeds, (std::vector<double>{1.0, 5.0, 0.0}));
}

TEST(Schedule, segments_start_from_rest_and_join_without_jumps) {
    const SpeedHistory history =
        history_of({.program = Segments{{{.to = rate(150.0), .duration = 60.0, .points = 50},
                                         {.to = rate(400.0), .duration = 30.0, .points = 25},
                                         {.to = rate(0.0), .duration = 5.0, .points = 10}}}});
    EXPECT_EQ(history.initial_speed, 0.0);
    ASSERT_EQ(history.pieces.size(), 3u);
    EXPECT_EQ(history.pieces[0].start_speed, 0.0);
    for (std::size_t i = 1; i < 3; ++i) {
        EXPECT_EQ(history.pieces[i].start_speed, history.pieces[i - 1].end_speed);
        EXPECT_EQ(history.pieces[i].start_time, history.pieces[i - 1].end_time);
    }
    EXPECT_EQ(history.row_times.size(), 85u);
    EXPECT_EQ(history.speed_at(95.0), 0.0);
    // Where two pieces meet, the time belongs to the earlier one.
    EXPECT_DOUBLE_EQ(history.acceleration_at(60.0), 150.0 / 4.0 / 60.0);
}

TEST(SpeedHistory, empty_history_is_refused) {
    EXPECT_THROW((void)SpeedHistory{}.speed_at(0.0), std::logic_error);
}

} // namespace
} // namespace searle::rheometry
