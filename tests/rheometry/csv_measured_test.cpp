#include "rheometry/converted_step.hpp"
#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "rheometry/tables/number_columns.hpp"

#include "places.hpp"
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <numbers>
#include <unistd.h>

namespace searle::rheometry {
namespace {

/// Reads a text as if it were a laboratory's file.
MeasuredData read(const std::string& text, DriveMotion motion = DriveMotion::turning) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("searle_measured_" + std::to_string(::getpid()) + ".csv");
    std::ofstream(file, std::ios::binary) << text;
    MeasuredData data = read_measured_data(file, motion);
    std::filesystem::remove(file);
    return data;
}

std::string message_of(const std::string& text, DriveMotion motion = DriveMotion::turning) {
    try {
        (void)read(text, motion);
    } catch (const TableError& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(csv_measured, the_contracts_own_columns_are_enough) {
    const MeasuredData data = read("angular_velocity_rad_s,torque_N_m\n2,0.001\n");
    ASSERT_EQ(data.steps.size(), 1U);
    EXPECT_EQ(data.steps[0].speed, std::vector<double>{2.0});
    EXPECT_EQ(data.steps[0].torque, std::vector<double>{0.001});
    EXPECT_TRUE(data.steps[0].time.empty());
}

// Conversion of each unit from its definition.
TEST(csv_measured, units_in_the_heading_are_converted) {
    const double pi = std::numbers::pi;
    struct Example {
        const char* heading;
        double speed;
        double torque;
    };
    for (const Example& example : {
             Example{"Speed [rpm];Torque [mN.m]", 2.0 * pi / 60.0, 1e-3},
             Example{"speed (1/min);torque (mN m)", 2.0 * pi / 60.0, 1e-3},
             Example{"Drehzahl [U/min];Drehmoment [mNm]", 2.0 * pi / 60.0, 1e-3},
             Example{"Rotational Speed [min^-1];TORQUE [\xC2\xB5N\xC2\xB7m]", 2.0 * pi / 60.0,
                     1e-6},
             Example{"Angular velocity [rad/s];Torque [uN.m]", 1.0, 1e-6},
             Example{"Velocity (mrad/s);Torque (nN.m)", 1e-3, 1e-9},
             Example{"speed [deg/s];torque [dyn.cm]", pi / 180.0, 1e-7},
             Example{"rotation_speed [rev/s];torque [N.m]", 2.0 * pi, 1.0},
         }) {
        const MeasuredData data = read(std::string(example.heading) + "\n1;1\n");
        EXPECT_NEAR(data.steps[0].speed[0], example.speed, 1e-14 * example.speed)
            << example.heading;
        EXPECT_NEAR(data.steps[0].torque[0], example.torque, 1e-14 * example.torque)
            << example.heading;
    }
}

TEST(csv_measured, units_in_a_line_below_the_header_are_converted) {
    const MeasuredData data = read("Time;Speed;Torque;Temperature\nmin;rad/s;mN.m;\xC2\xB0"
                                   "C\n2;3;4;20,1\n");
    EXPECT_DOUBLE_EQ(data.steps[0].time[0], 120.0);
    EXPECT_DOUBLE_EQ(data.steps[0].torque[0], 4e-3);
}

TEST(csv_measured, a_missing_column_lists_what_is_accepted_and_what_is_there) {
    const std::string message = message_of("speed [rad/s],Drehmomentt [mNm]\n1,2\n");
    EXPECT_TRUE(contains(message, ":1: column \"torque_N_m\": the column is missing")) << message;
    EXPECT_TRUE(contains(message, "drehmoment")) << message;
    EXPECT_TRUE(contains(message, "\"Drehmomentt [mNm]\"")) << message;
}

TEST(csv_measured, missing_wrong_and_contradicting_units_are_refused) {
    EXPECT_TRUE(contains(message_of("speed,torque_N_m\n1,2\n"), "has no unit"));
    EXPECT_TRUE(contains(message_of("speed [1/s],torque_N_m\n1,2\n"), "\"1/s\" is no unit"));
    EXPECT_TRUE(contains(message_of("speed [rad/s],torque [Pa]\n1,2\n"), "\"Pa\" is no unit"));
    EXPECT_TRUE(
        contains(message_of("speed [rpm],torque_N_m\nrad/s,N.m\n1,2\n"), "different units"));
    EXPECT_TRUE(contains(message_of("angular_velocity_rad_s,torque_N_m\nrpm,N.m\n1,2\n"),
                         "different units"));
}

TEST(csv_measured, two_columns_that_could_be_meant_are_refused_unless_one_has_the_si_name) {
    EXPECT_TRUE(contains(message_of("speed [rpm],angular velocity [rad/s],torque_N_m\n1,2,3\n"),
                         "could be meant"));
    const MeasuredData data = read("speed [rpm],angular_velocity_rad_s,torque_N_m\n1,2,3\n");
    EXPECT_EQ(data.steps[0].speed[0], 2.0);
}

TEST(csv_measured, faults_of_both_columns_are_told_together) {
    const std::string message = message_of("angular_velocity_rad_s,torque_N_m\n1,\nx,2\n3,nan\n");
    EXPECT_TRUE(contains(message, ":2: column \"torque_N_m\": the field is empty")) << message;
    EXPECT_TRUE(contains(message, ":3: column \"angular_velocity_rad_s\"")) << message;
    EXPECT_TRUE(contains(message, ":4: column \"torque_N_m\": \"nan\" is not a finite number"))
        << message;
}

TEST(csv_measured, a_box_wants_speed_and_force) {
    const MeasuredData data = read("wall speed [mm/s],force [mN]\n1,2\n", DriveMotion::sliding);
    EXPECT_DOUBLE_EQ(data.steps[0].speed[0], 1e-3);
    EXPECT_DOUBLE_EQ(data.steps[0].torque[0], 2e-3);
    EXPECT_TRUE(
        contains(message_of("angular_velocity_rad_s,torque_N_m\n1,2\n", DriveMotion::sliding),
                 "wall_speed_m_s"));
}

TEST(csv_measured, an_xlsx_workbook_is_told_apart) {
    EXPECT_TRUE(contains(message_of("PK\x03\x04 and so on"), "damaged zip archive"));
}

TEST(csv_measured, converted_table_has_the_documented_columns) {
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const Conversion conversion = conversion_for(bob, {});
    MeasuredStep step;
    step.name = "Flow, \"first\"";
    step.time = {1.0};
    step.speed = {2.0};
    step.torque = {1e-3};
    const std::vector<ConvertedStep> steps{convert_step(step, bob, conversion)};
    const std::string table = converted_csv(steps, bob, conversion);
    EXPECT_TRUE(table.starts_with(
        "time_s,angular_velocity_rad_s,torque_N_m,shear_rate_1_s,shear_stress_Pa,viscosity_Pa_s,"
        "bob_stress_Pa,bob_rate_true_1_s,bob_rate_standard_error_1_s,branch,step,definition,"
        "end_factor\n"))
        << table;
    // 16243.2702 Pa/(N m) and 12.187215 1/rad: physics.md section 1.
    EXPECT_NEAR(steps[0].rheogram.points[0].shear_stress, 16.2432702, 1e-7);
    EXPECT_NEAR(steps[0].rheogram.points[0].shear_rate, 2.0 * 12.187215, 1e-6);
    EXPECT_TRUE(table.find(",nan,nan,unknown,\"Flow, \"\"first\"\"\",iso-3219,1.1") !=
                std::string::npos)
        << table;
}

// The example holds the stress and the rate that the instrument's own software wrote, to 6 digits.
TEST(csv_measured, the_measured_example_converts_to_the_instruments_own_columns) {
    const std::filesystem::path file =
        std::filesystem::path(SEARLE_SOURCE_DIR) / "cases" / "measured-surfactant.csv";
    const MeasuredData data = read_measured_data(file, DriveMotion::turning);
    const CsvTable table = CsvTable::read(file);
    NumberColumns numbers(table);
    MeasuredStep step = data.steps.at(0);
    step.exported_stress =
        numbers.read(table.find("Stress [Pa]").value(), MissingValues::forbidden);
    step.exported_rate =
        numbers.read(table.find("Shear rate [1/s]").value(), MissingValues::forbidden);
    ASSERT_EQ(step.torque.size(), 41U);
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const ConvertedStep converted = convert_step(step, bob, conversion_for(bob, {}));
    EXPECT_LT(converted.stress_difference, 1e-5);
    EXPECT_LT(converted.rate_difference, 1e-5);
    // At low rates the fluid is Newtonian, where bob rate / ISO rate = 2 delta^2 / (1 + delta^2).
    const double delta = bob.radius_ratio();
    const WallRate& slow = converted.at_rotor.rates.rows[30];
    const double ratio = slow.rate / converted.rheogram.points[30].shear_rate;
    EXPECT_NEAR(ratio, 2.0 * delta * delta / (1.0 + delta * delta), 1e-3);
    EXPECT_EQ(slow.branch, GapBranch::sheared);
}

} // namespace
} // namespace searle::rheometry
