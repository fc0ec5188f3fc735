#include "rheometry/rheogram_csv.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <unistd.h>

namespace searle::rheometry {
namespace {

class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& content)
        : path_(std::filesystem::temp_directory_path() /
                ("searle_rheogram_" + std::to_string(::getpid()) + ".csv")) {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

// contract.md, "Result folder": the header is exactly this; further columns may follow.
TEST(rheogram_csv, header_is_that_of_the_contract) {
    EXPECT_TRUE(rheogram_header(DriveColumns::turning)
                    .starts_with("time_s,angular_velocity_rad_s,torque_N_m,shear_rate_1_s,"
                                 "shear_stress_Pa,viscosity_Pa_s,stress_error_Pa,regime,"));
    EXPECT_TRUE(rheogram_header(DriveColumns::sliding)
                    .starts_with("time_s,wall_speed_m_s,wall_force_N,shear_rate_1_s,"
                                 "shear_stress_Pa,viscosity_Pa_s,stress_error_Pa,regime,"));
}

TEST(rheogram_csv, what_is_written_reads_back_bit_by_bit) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> exponent(-300.0, 300.0);
    Rheogram rheogram;
    for (int row = 0; row < 200; ++row) {
        const auto value = [&] { return std::pow(10.0, exponent(random)); };
        rheogram.points.push_back({value(), -value(), value(), value(), value(), value(), value(),
                                   row % 2 == 0 ? "laminar" : "laminar+lag", value(), std::nan(""),
                                   value()});
    }
    for (const DriveColumns columns : {DriveColumns::turning, DriveColumns::sliding}) {
        std::ostringstream stream;
        write_rheogram_csv(stream, rheogram, columns);
        const TemporaryFile file(stream.str());
        const RheogramFile read = read_rheogram_csv(file.path());
        EXPECT_EQ(read.columns, columns);
        ASSERT_EQ(read.rheogram.points.size(), rheogram.points.size());
        for (std::size_t row = 0; row < rheogram.points.size(); ++row) {
            const RheogramPoint& one = rheogram.points[row];
            const RheogramPoint& other = read.rheogram.points[row];
            for (const auto member :
                 {&RheogramPoint::time, &RheogramPoint::speed, &RheogramPoint::torque,
                  &RheogramPoint::shear_rate, &RheogramPoint::shear_stress,
                  &RheogramPoint::viscosity, &RheogramPoint::stress_error,
                  &RheogramPoint::steady_stress, &RheogramPoint::yield_radius})
                EXPECT_EQ(std::bit_cast<std::uint64_t>(one.*member),
                          std::bit_cast<std::uint64_t>(other.*member));
            EXPECT_TRUE(std::isnan(other.bob_shear_rate));
            EXPECT_EQ(one.regime, other.regime);
        }
    }
}

// contract.md: `fit` needs only these two columns.
TEST(rheogram_csv, rate_and_stress_alone_are_enough) {
    const TemporaryFile file("shear_rate_1_s,shear_stress_Pa\n10,5\n20,8\n");
    const Rheogram rheogram = read_rheogram_csv(file.path()).rheogram;
    ASSERT_EQ(rheogram.points.size(), 2U);
    EXPECT_EQ(rheogram.points[1].viscosity, 0.4);
    EXPECT_TRUE(std::isnan(rheogram.points[1].torque));
}

TEST(rheogram_csv, a_missing_stress_is_an_error_with_file_line_and_column) {
    const TemporaryFile file("# made by hand\nshear_rate_1_s,regime\n10,laminar\n");
    try {
        (void)read_rheogram_csv(file.path());
        FAIL() << "no error";
    } catch (const TableError& error) {
        ASSERT_EQ(error.faults().size(), 1U);
        EXPECT_EQ(error.faults()[0].line, 2U);
        EXPECT_EQ(error.faults()[0].column, "shear_stress_Pa");
        EXPECT_TRUE(std::string(error.what()).starts_with(file.path().string() + ":2: "));
    }
}

TEST(rheogram_csv, columns_of_both_drives_are_refused) {
    const TemporaryFile file("torque_N_m,wall_force_N,shear_rate_1_s,shear_stress_Pa\n1,1,10,5\n");
    EXPECT_THROW((void)read_rheogram_csv(file.path()), TableError);
}

// The one lift of torque to stress: 2.0 Pa per N m and 3.0 1/s per rad/s by construction.
TEST(rheogram_csv, make_rheogram_lifts_every_torque_once) {
    const Conversion conversion{.stress_per_torque = 2.0, .rate_per_speed = 3.0};
    const TorqueHistory history{{{.time = 1.0,
                                  .speed = -4.0,
                                  .torque = -5.0,
                                  .torque_error = 0.25,
                                  .steady_torque = -4.5,
                                  .yield_radius = 0.01},
                                 {.time = 2.0, .speed = 0.0}}};
    const std::vector<std::string> regimes{"laminar", "rest"};
    const std::vector<double> bob_rates{12.5, 0.0};
    const Rheogram rheogram = make_rheogram(history, conversion, regimes, bob_rates);
    const RheogramPoint& moving = rheogram.points[0];
    EXPECT_EQ(moving.shear_rate, -12.0);
    EXPECT_EQ(moving.shear_stress, -10.0);
    EXPECT_EQ(moving.viscosity, 10.0 / 12.0);
    EXPECT_EQ(moving.stress_error, 0.5);
    EXPECT_EQ(moving.steady_stress, -9.0);
    EXPECT_EQ(moving.bob_shear_rate, 12.5);
    EXPECT_TRUE(std::isnan(rheogram.points[1].viscosity));
    EXPECT_THROW((void)make_rheogram(history, conversion, {}), std::invalid_argument);
}

} // namespace
} // namespace searle::rheometry
