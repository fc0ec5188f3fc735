#include "rheometry/tables/trios_json.hpp"

#include "rheometry/tables/flow_curves.hpp"
#include "rheometry/tables/measured_data.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace searle::rheometry {
namespace {

class JsonFile {
public:
    explicit JsonFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() /
                ("searle_trios_" + std::to_string(::getpid()) + ".json")) {
        std::ofstream(path_) << text;
    }
    ~JsonFile() { std::filesystem::remove(path_); }
    JsonFile(const JsonFile&) = delete;
    JsonFile& operator=(const JsonFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// As the published schema (https://software.tainstruments.com/schemas/TRIOSJSONExportSchema) has
/// it; all columns stand in all rows, those of the sweep in oscillation included.
const std::string exported = R"({
 "Schema": {"Url": "https://software.tainstruments.com/schemas/TRIOSJSONExportSchema"},
 "Operators": [{"Name": "X"}],
 "Sample": {"Name": "slurry"},
 "Procedure": {"Name": "flow", "Steps": [], "Configuration": {"InstrumentConfigurations": [
   {"Type": "DHR", "Geometry": {"Name": "DIN bob", "BobDiameter": {"Value": 28.0, "Unit": {"Name": "mm"}},
     "CupDiameter": {"Value": 30.4, "Unit": {"Name": "mm"}}, "EndEffectFactor": {"Value": 1.1},
     "StressConstant": {"Value": 16243.27, "Unit": {"Name": "Pa/N.m"}}}}]}},
 "Results": {"Processed": {
   "ResultsSteps": [{"Id": "aa", "Name": "Amplitude - 1"}, {"Id": "bb", "Name": "Flow sweep - 2"}],
   "ColumnHeaders": {
     "Torque_µN.m": {"DisplayName": "Torque", "ValueType": "Number", "Unit": {"Name": "µN.m"}},
     "Velocity_rad/s": {"DisplayName": "Velocity", "ValueType": "Number", "Unit": {"Name": "rad/s"}},
     "Shear rate_1/s": {"DisplayName": "Shear rate", "ValueType": "Number", "Unit": {"Name": "1/s"}},
     "Stress_Pa": {"DisplayName": "Stress", "ValueType": "Number", "Unit": {"Name": "Pa"}},
     "Step time_s": {"DisplayName": "Step time", "ValueType": "Number", "Unit": {"Name": "s"}},
     "Results Step Id": {"DisplayName": "Results Step Id", "ValueType": "Uuid"},
     "Status": {"DisplayName": "Status", "ValueType": "Text"}},
   "Rows": [
     {"Torque_µN.m": 1.0, "Velocity_rad/s": 0.1, "Shear rate_1/s": 1.0, "Stress_Pa": 2.0, "Results Step Id": "aa"},
     {"Torque_µN.m": 250.0, "Velocity_rad/s": 2.0, "Shear rate_1/s": 24.4, "Stress_Pa": 4.06, "Step time_s": 10, "Status": "ok", "Results Step Id": "bb"},
     {"Torque_µN.m": null, "Velocity_rad/s": 3.0, "Shear rate_1/s": 36.6, "Stress_Pa": null, "Step time_s": 20, "Results Step Id": "bb"},
     {"Torque_µN.m": 400.0, "Velocity_rad/s": 4.0, "Shear rate_1/s": 48.7, "Stress_Pa": 6.5, "Step time_s": 30, "Results Step Id": "bb"}]}}})";

TEST(TriosJson, steps_of_flow_are_read_with_their_geometry) {
    const JsonFile file(exported);
    const MeasuredData data = read_measured_data(file.path(), DriveMotion::turning);
    ASSERT_EQ(data.steps.size(), 1U);
    const MeasuredStep& step = data.steps.front();
    EXPECT_EQ(step.name, "Flow sweep - 2");
    ASSERT_EQ(step.torque.size(), 2U); // the row without a torque is left out
    EXPECT_NEAR(step.torque[1], 400e-6, 1e-18);
    EXPECT_EQ(step.speed, (std::vector<double>{2.0, 4.0}));
    EXPECT_EQ(step.time, (std::vector<double>{10.0, 30.0}));
    ASSERT_TRUE(data.geometry.bob_radius && data.geometry.cup_radius && data.geometry.end_factor);
    EXPECT_DOUBLE_EQ(*data.geometry.bob_radius, 0.014);
    EXPECT_DOUBLE_EQ(*data.geometry.cup_radius, 0.0152);
    EXPECT_DOUBLE_EQ(*data.geometry.end_factor, 1.1);
    EXPECT_NEAR(*data.geometry.stress_constant, 16243.27, 1e-6);
    ASSERT_EQ(data.remarks.size(), 2U);
    EXPECT_NE(data.remarks[0].find("Amplitude - 1"), std::string::npos);
    EXPECT_NE(data.remarks[1].find("1 of 3 rows"), std::string::npos);
}

TEST(TriosJson, the_software_s_own_rate_and_stress_are_a_flow_curve) {
    const JsonFile file(exported);
    const FlowCurveFile read = read_flow_curves(file.path());
    ASSERT_EQ(read.curves.size(), 1U);
    ASSERT_EQ(read.curves[0].points.size(), 2U);
    EXPECT_DOUBLE_EQ(read.curves[0].points[1].rate, 48.7);
    EXPECT_DOUBLE_EQ(read.curves[0].points[1].stress, 6.5);
}

std::string message_of(const std::string& text) {
    const JsonFile file(text);
    try {
        (void)read_flow_curves(file.path());
    } catch (const TableError& error) {
        return error.what();
    }
    return "";
}

TEST(TriosJson, other_json_and_damaged_json_are_refused_with_a_reason) {
    EXPECT_NE(message_of(R"({"a": 1})").find("no export of TRIOS"), std::string::npos);
    EXPECT_NE(message_of(exported.substr(0, 900)).find("none"), std::string::npos);
    EXPECT_NE(message_of(R"({"Results": {"Processed": {"ColumnHeaders": {}, "Rows": []}}})")
                  .find("no rows"),
              std::string::npos);
    EXPECT_NE(message_of(R"({"Results": {"Processed": {"ColumnHeaders": [], "Rows": 3}}})")
                  .find("no export of TRIOS"),
              std::string::npos);
    // Members of other kinds than the schema's do no harm.
    EXPECT_NE(message_of(R"({"Procedure": 5, "Results": {"Processed": {"ColumnHeaders":
        {"a": 7, "b": {"ValueType": "Number", "DisplayName": 3}}, "Rows": [1, {"b": "x"}]}}})"),
              "");
}

} // namespace
} // namespace searle::rheometry
