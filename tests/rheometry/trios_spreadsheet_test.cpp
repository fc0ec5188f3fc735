#include "rheometry/converted_step.hpp"
#include "rheometry/tables/isolated_call.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "rheometry/tables/spreadsheet.hpp"

#include "places.hpp"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <stdexcept>
#include <unistd.h>

namespace searle::rheometry {
namespace {

const std::filesystem::path measured_data =
    std::filesystem::path(SEARLE_SOURCE_DIR) / ".." / "shared" / "data";

std::filesystem::path surfactant() { return measured_data / "din_cylinder_surfactant_15C.xls"; }
std::filesystem::path emulsion() { return measured_data / "din_cylinder_emulsion_85.xls"; }

#define SKIP_WITHOUT(file)                                                                         \
    if (!std::filesystem::exists(file))                                                            \
    GTEST_SKIP() << file << " is not here: the measured sets are kept outside of the project"

const MeasuredStep& step_named(const MeasuredData& data, std::string_view name) {
    const auto found = std::ranges::find(data.steps, name, &MeasuredStep::name);
    if (found == data.steps.end())
        throw std::runtime_error("no step " + std::string(name));
    return *found;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class DamagedCopy {
public:
    explicit DamagedCopy(const std::string& bytes)
        : path_(std::filesystem::temp_directory_path() /
                ("searle_damaged_" + std::to_string(::getpid()) + ".xls")) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~DamagedCopy() { std::filesystem::remove(path_); }
    DamagedCopy(const DamagedCopy&) = delete;
    DamagedCopy& operator=(const DamagedCopy&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string message_of(const std::filesystem::path& file) {
    try {
        (void)read_measured_data(file, DriveMotion::turning);
    } catch (const TableError& error) {
        return error.what();
    }
    return {};
}

// The export's own stress and rate columns have 6 significant digits, as have torque and velocity:
// half a unit of the sixth digit in each of the two is 1e-5 at most.
constexpr double six_digits = 1e-5;

TEST(trios_spreadsheet, stress_and_rate_equal_the_exports_own_columns) {
    SKIP_WITHOUT(surfactant());
    const MeasuredData data = read_measured_data(surfactant(), DriveMotion::turning);
    const MeasuredStep& sweep = step_named(data, "Flow sweep - 3");
    ASSERT_EQ(sweep.torque.size(), 41U);
    ASSERT_EQ(sweep.exported_stress.size(), 41U);
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const ConvertedStep converted = convert_step(sweep, bob, conversion_for(bob, {}));
    EXPECT_LT(converted.stress_difference, six_digits);
    EXPECT_LT(converted.rate_difference, six_digits);
    // First row of the sheet: 10561.7 uN.m, 82.051 rad/s, 171.557 Pa, 999.973 1/s.
    EXPECT_DOUBLE_EQ(sweep.torque[0], 10561.7e-6);
    EXPECT_DOUBLE_EQ(sweep.speed[0], 82.051);
    EXPECT_NEAR(converted.rheogram.points[0].shear_stress, 171.557, 5e-4);
    EXPECT_NEAR(converted.rheogram.points[0].shear_rate, 999.973, 5e-4);
}

TEST(trios_spreadsheet, steps_without_torque_are_left_out_with_a_remark) {
    SKIP_WITHOUT(surfactant());
    const MeasuredData data = read_measured_data(surfactant(), DriveMotion::turning);
    EXPECT_EQ(data.steps.size(), 5U);
    EXPECT_TRUE(std::ranges::any_of(data.remarks, [](const std::string& remark) {
        return remark.starts_with("step \"Amplitude sweep - 1\" left out");
    }));
}

// The start-ups were driven at 0.1 ... 1000 1/s; the last one at 1000 / 12.18721 rad/s.
TEST(trios_spreadsheet, start_up_speed_comes_from_the_displacement) {
    SKIP_WITHOUT(surfactant());
    const MeasuredData data = read_measured_data(surfactant(), DriveMotion::turning);
    const MeasuredStep& start_up = step_named(data, "Stress growth - 7");
    EXPECT_FALSE(start_up.is_flow_curve);
    EXPECT_NEAR(start_up.speed.back(), 1000.0 / 12.18721, 0.01 * 82.05);
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const ConvertedStep converted = convert_step(start_up, bob, conversion_for(bob, {}));
    EXPECT_LT(converted.stress_difference, six_digits);
    EXPECT_TRUE(std::isnan(converted.at_rotor.rates.rows.front().rate));
}

TEST(trios_spreadsheet, speed_without_velocity_column_comes_from_the_strain_constant) {
    SKIP_WITHOUT(emulsion());
    const MeasuredData data = read_measured_data(emulsion(), DriveMotion::turning);
    EXPECT_NEAR(data.geometry.bob_radius.value(), 0.014, 1e-12);
    EXPECT_NEAR(data.geometry.cup_radius.value(), 0.0152, 1e-12);
    EXPECT_NEAR(data.geometry.bob_length.value(), 0.042, 1e-12);
    EXPECT_EQ(data.geometry.end_factor.value(), 1.10);
    EXPECT_NEAR(data.geometry.stress_constant.value(), 16243.3, 1e-9);
    EXPECT_NEAR(data.geometry.strain_constant.value(), 12.1872, 1e-12);
    const MeasuredStep& sweep = step_named(data, "Flow sweep - 2");
    ASSERT_EQ(sweep.speed.size(), 71U);
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const ConvertedStep converted = convert_step(sweep, bob, conversion_for(bob, {}));
    EXPECT_LT(converted.stress_difference, six_digits);
    EXPECT_LT(converted.rate_difference, six_digits);
}

TEST(trios_spreadsheet, what_is_no_workbook_is_refused) {
    const DamagedCopy text("angular_velocity_rad_s,torque_N_m\n1,2\n");
    EXPECT_THROW((void)read_spreadsheet(text.path()), TableError);
    EXPECT_TRUE(message_of("no/such/file.xls").find("no such file") != std::string::npos);
    EXPECT_TRUE(message_of(std::filesystem::temp_directory_path()).find("directory") !=
                std::string::npos);
    const DamagedCopy header_only("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1 and no more");
    EXPECT_TRUE(message_of(header_only.path()).find("damaged") != std::string::npos);
}

TEST(trios_spreadsheet, an_export_does_not_fit_a_box) {
    const DamagedCopy header_only("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1 and no more");
    EXPECT_THROW((void)read_measured_data(header_only.path(), DriveMotion::sliding), TableError);
}

// Whatever is damaged, either a table or a TableError comes out; the library itself crashes on some
// of these, which is why it runs in a process of its own.
TEST(trios_spreadsheet, damaged_workbooks_do_no_harm) {
    SKIP_WITHOUT(emulsion());
    const std::string whole = bytes_of(emulsion());
    std::mt19937 random(17);
    int refused = 0;
    for (int repeat = 0; repeat < 60; ++repeat) {
        std::string bytes = whole;
        const std::size_t place = random() % bytes.size();
        if (repeat % 3 == 0) {
            bytes.resize(place);
        } else if (repeat % 3 == 1) {
            for (int i = 0; i < 20; ++i)
                bytes[random() % 2048] = static_cast<char>(random());
        } else {
            const std::size_t count = std::min<std::size_t>(512, bytes.size() - place);
            bytes.replace(place, count, count, '\xFF');
        }
        const DamagedCopy copy(bytes);
        refused += message_of(copy.path()).empty() ? 0 : 1;
    }
    EXPECT_GE(refused, 20);
}

TEST(trios_spreadsheet, a_crash_stays_in_its_own_process) {
    const IsolatedResult crashed = call_isolated([]() -> std::string {
        (void)std::raise(SIGSEGV);
        return "unreachable";
    });
    EXPECT_EQ(crashed.outcome, IsolatedResult::Outcome::crashed);
    const IsolatedResult thrown =
        call_isolated([]() -> std::string { throw std::runtime_error("no"); });
    EXPECT_EQ(thrown.outcome, IsolatedResult::Outcome::crashed);
    const std::string large(5'000'000, 'x');
    const IsolatedResult finished = call_isolated([&large] { return large; });
    EXPECT_EQ(finished.outcome, IsolatedResult::Outcome::finished);
    EXPECT_EQ(finished.output, large);
}

TEST(trios_spreadsheet, memory_beyond_the_limit_is_refused_to_the_process) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer needs addresses without a limit";
#endif
    const IsolationLimits limits{.memory = std::size_t{64} << 20U};
    const auto call = [](std::size_t size) { return [size] { return std::string(size, 'x'); }; };
    EXPECT_EQ(call_isolated(call(std::size_t{1} << 20U), limits).outcome,
              IsolatedResult::Outcome::finished);
    EXPECT_EQ(call_isolated(call(std::size_t{256} << 20U), limits).outcome,
              IsolatedResult::Outcome::crashed);
}

TEST(trios_spreadsheet, the_library_tells_its_version) {
    EXPECT_FALSE(spreadsheet_library_version().empty());
}

} // namespace
} // namespace searle::rheometry
