#include "app/verb_fit.hpp"

#include "app/usage_error.hpp"
#include "rheometry/tables/table_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace app = searle::app;
namespace fs = std::filesystem;

class FitVerb : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("searle_fit_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path write(const char* name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }
    /// Herschel-Bulkley 5 Pa, 0.9 Pa s^n, 0.55, without scatter.
    fs::path flow_curve() {
        std::ostringstream text;
        text.precision(17);
        text << "shear_rate_1_s,shear_stress_Pa\n";
        for (int i = 0; i <= 20; ++i) {
            const double rate = std::pow(10.0, -1.0 + 0.2 * i);
            text << rate << ',' << 5.0 + 0.9 * std::pow(rate, 0.55) << '\n';
        }
        return write("curve.csv", text.str());
    }
    static std::string content(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    fs::path folder_;
};

TEST_F(FitVerb, json_holds_what_scripts_expect) {
    app::FitVerbOptions options;
    options.data_files = {flow_curve()};
    options.outputs = {folder_ / "fit.json"};
    testing::internal::CaptureStdout();
    EXPECT_EQ(app::fit_laws(options), 0);
    testing::internal::GetCapturedStdout();
    const auto json = nlohmann::json::parse(content(folder_ / "fit.json"));
    EXPECT_EQ(json.at("model"), "herschel-bulkley");
    const auto& yield = json.at("parameters").at("yield_stress");
    EXPECT_NEAR(yield.at("value").get<double>(), 5.0, 1e-6);
    EXPECT_EQ(yield.at("unit"), "Pa");
    EXPECT_EQ(yield.at("ci95").size(), 2U);
    EXPECT_TRUE(yield.contains("standard_error"));
    EXPECT_EQ(json.at("points_used"), 21);
    for (const char* key : {"covariance", "residuals", "aicc"})
        EXPECT_TRUE(json.contains(key)) << key;
}

TEST_F(FitVerb, all_laws_are_a_list_best_first) {
    app::FitVerbOptions options;
    options.data_files = {flow_curve()};
    options.model = "all";
    options.outputs = {folder_ / "fit.json", folder_ / "fit.html", folder_ / "fit.csv"};
    testing::internal::CaptureStdout();
    EXPECT_EQ(app::fit_laws(options), 0);
    testing::internal::GetCapturedStdout();
    const auto json = nlohmann::json::parse(content(folder_ / "fit.json"));
    ASSERT_EQ(json.size(), 10U);
    EXPECT_EQ(json[0].at("model"), "herschel-bulkley");
    EXPECT_NE(content(folder_ / "fit.html").find("<svg"), std::string::npos);
    EXPECT_NE(content(folder_ / "fit.csv").find("yield_stress"), std::string::npos);
}

TEST_F(FitVerb, unknown_words_are_usage_errors) {
    app::FitVerbOptions options;
    options.data_files = {flow_curve()};
    options.model = "herschel";
    EXPECT_THROW((void)app::fit_laws(options), app::UsageError);
    options.model = "bingham";
    options.range = "5";
    EXPECT_THROW((void)app::fit_laws(options), app::UsageError);
    options.range.reset();
    options.outputs = {folder_ / "fit.pdf"};
    EXPECT_THROW((void)app::fit_laws(options), app::UsageError);
}

TEST_F(FitVerb, too_few_points_end_with_exit_code_2) {
    app::FitVerbOptions options;
    options.data_files = {write("two.csv", "shear_rate_1_s,shear_stress_Pa\n1,5\n2,6\n")};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(app::fit_laws(options), 2);
    testing::internal::GetCapturedStdout();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("2 usable points"), std::string::npos);
}

} // namespace
