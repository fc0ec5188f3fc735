#include "tests/app/running.hpp"

#include <cmath>
#include <sstream>

// Rheograms as they should not be, given to `searle fit`: a result with its warning, or an error
// that names row and column.

namespace {

using searle::app::testing::Outcome;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::write_text;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Herschel-Bulkley 5 Pa, 0.9, 0.55 with 1 % of scatter by a fixed sequence; rows 0 ... 20.
std::string row(int k, const std::string& delimiter = ",") {
    const double rate = std::pow(10.0, -1.0 + 0.2 * k);
    std::ostringstream text;
    text.precision(8);
    text << rate << delimiter
         << (5.0 + 0.9 * std::pow(rate, 0.55)) * (1.0 + 0.01 * std::sin(11.0 * k * k)) << '\n';
    return text.str();
}

std::string rows(int first = 0, int last = 20) {
    std::string text;
    for (int k = first; k <= last; ++k)
        text += row(k);
    return text;
}

const std::string header = "shear_rate_1_s,shear_stress_Pa\n";

class FitBadInput : public ::testing::Test {
protected:
    Outcome fit(const std::string& text, std::vector<std::string> words = {}) const {
        write_text(folder / "curve.csv", text);
        words.insert(words.begin(), {"fit", "curve.csv"});
        return searle(words, folder.path());
    }
    /// Exit code 0 and a text on stdout or stderr.
    void expect_result(const std::string& text, const std::string& said) const {
        const Outcome outcome = fit(text);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(holds(outcome.out + outcome.err, said)) << said << "\n"
                                                            << outcome.out << outcome.err;
        EXPECT_TRUE(holds(outcome.out, "yield_stress")) << outcome.out;
    }
    void expect_error(const std::string& text, const std::string& said) const {
        const Outcome outcome = fit(text);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
        EXPECT_TRUE(holds(outcome.err, said)) << said << "\n" << outcome.err;
    }

    TemporaryFolder folder;
};

TEST_F(FitBadInput, two_points) {
    expect_error(header + rows(0, 1), "2 usable points cannot determine 3 parameters");
}

TEST_F(FitBadInput, a_decade_is_missing) {
    expect_result(header + rows(0, 5) + rows(14, 20), "no point between 1 and 63.1 1/s");
}

TEST_F(FitBadInput, all_stresses_are_equal) {
    std::string text = header;
    for (int k = 0; k < 10; ++k)
        text += std::to_string(1 << k) + ",7\n";
    expect_result(text, "all stresses are equal");
}

TEST_F(FitBadInput, a_negative_stress) {
    expect_result(header + rows(0, 9) + "15,-6\n" + rows(10, 20),
                  "(line 12): the shear stress has not the sign");
}

TEST_F(FitBadInput, a_zero_rate) {
    expect_result(header + "0,4.9\n" + rows(), "(line 2): at rest");
}

TEST_F(FitBadInput, duplicates) {
    expect_result(header + rows() + row(4), "1 of 22 points repeat a shear rate");
}

// Order does not matter: the same numbers come out.
TEST_F(FitBadInput, unsorted) {
    std::string backwards = header;
    for (int k = 20; k >= 0; --k)
        backwards += row(k);
    EXPECT_EQ(fit(backwards).out, fit(header + rows()).out);
}

TEST_F(FitBadInput, missing_numbers) {
    expect_result(header + rows(0, 4) + "0.7,nan\nnan,6\n,\n" + rows(5, 20),
                  "(line 7): the shear stress is missing");
}

TEST_F(FitBadInput, text_in_place_of_a_number) {
    expect_error(header + rows(0, 3) + "0.5,much\n" + rows(4, 20),
                 "curve.csv:6: column \"shear_stress_Pa\": \"much\" is not a number");
}

TEST_F(FitBadInput, a_wrong_delimiter) {
    std::string text = "shear_rate_1_s|shear_stress_Pa\n";
    for (int k = 0; k <= 20; ++k)
        text += row(k, "|");
    expect_error(text, "the delimiter must be comma, semicolon or tab");
}

TEST_F(FitBadInput, a_column_in_other_units) {
    expect_result("shear rate [1/s],shear stress [dyn/cm^2]\n" + rows(), "Pa ");
    expect_error("shear rate [1/s],shear stress [Pa.s]\n" + rows(),
                 "\"Pa.s\" is no unit of this quantity; allowed: Pa");
    expect_error("shear rate,shear stress\n" + rows(), "the column has no unit");
}

TEST_F(FitBadInput, a_fit_on_the_bound) {
    const Outcome outcome = fit(header + rows(), {"--bounds", "flow_index=0.6:0.9"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(holds(outcome.out, "flow_index lies on its bound, 0.6")) << outcome.out;
}

TEST_F(FitBadInput, thousands_separators) {
    expect_error(header + "1,\"1,000\"\n2,\"1,500\"\n3,\"2,000\"\n4,\"2,100\"\n",
                 "curve.csv:2: column \"shear_stress_Pa\": \"1,000\" may mean 1000 or 1.000");
    // Another number shows that the comma is a decimal one.
    expect_result(header + "1,\"1,000\"\n2,\"1,5\"\n3,\"2,000\"\n4,\"2,100\"\n5,\"2,2\"\n", "Pa");
}

TEST_F(FitBadInput, numbers_beyond_any_measurement) {
    expect_error(header + "1,1e308\n2,1e308\n3,1e308\n4,1e308\n", "no measurement is");
    expect_error(header + "1e-200,1e-250\n2e-200,2e-250\n3e-200,3e-250\n4e-200,4e-250\n",
                 "no measurement is");
}

TEST_F(FitBadInput, many_rows) {
    std::string text = header;
    for (int k = 0; k < 200'000; ++k)
        text += row(k % 21);
    const Outcome outcome = fit(text, {"--model", "herschel-bulkley"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "200000 points"));
}

} // namespace
