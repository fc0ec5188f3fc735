#include "rheometry/report/fit_page.hpp"

#include "markup_check.hpp"
#include "rheometry/fit/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

namespace fit = searle::rheometry::fit;
namespace report = searle::rheometry::report;
using searle::test::drawings_in;
using searle::test::markup_fault;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

report::FittedCurve fitted(const std::string& name, const std::vector<std::string>& laws) {
    report::FittedCurve curve{.name = name, .data = {}, .laws = {}, .failure = {}};
    for (int k = 0; k < 15; ++k) {
        const double rate = std::pow(10.0, -1.0 + 0.25 * k);
        curve.data.rates.push_back(rate);
        curve.data.stresses.push_back((5.0 + 0.9 * std::pow(rate, 0.55)) *
                                      (1.0 + 0.01 * std::sin(5.0 * k)));
        curve.data.lines.push_back(0);
    }
    for (const std::string& law : laws)
        curve.laws.push_back(
            {fit::model_named(law), fit::fit_flow_curve(*fit::model_named(law), curve.data, {})});
    return curve;
}

std::string page_of(std::vector<report::FittedCurve> curves) {
    return report::render_fit_page({.curves = std::move(curves), .program_version = "0.1.0"});
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(FitPage, one_curve_has_both_figures_the_table_and_the_correlations) {
    const std::string page = page_of({fitted("curve", {"herschel-bulkley"})});
    const auto drawings = drawings_in(page);
    ASSERT_EQ(drawings.size(), 2U);
    for (const std::string& drawing : drawings)
        EXPECT_EQ(markup_fault(drawing), "");
    for (const char* part : {"yield_stress", "consistency", "flow_index", "95 % of the curve",
                             "95 % of a point", "Correlation", "Pa.s^n"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("Laws by AICc"), std::string::npos);
    // Self-contained.
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
}

TEST(FitPage, several_laws_are_ranked) {
    const std::string page = page_of({fitted("curve", {"herschel-bulkley", "bingham", "casson"})});
    EXPECT_NE(page.find("Laws by AICc"), std::string::npos);
    EXPECT_EQ(count(page, "<td>casson</td>"), 1U);
}

TEST(FitPage, names_and_warnings_cannot_break_the_page) {
    report::FittedCurve curve = fitted("a <b> & \"c\"", {"bingham"});
    curve.laws.front().result.warnings.push_back("x < y & z");
    const std::string page = page_of({curve});
    EXPECT_NE(page.find("a &lt;b&gt; &amp;"), std::string::npos);
    EXPECT_NE(page.find("x &lt; y &amp; z"), std::string::npos);
    EXPECT_EQ(page.find("<b> &"), std::string::npos);
}

TEST(FitPage, a_curve_that_failed_keeps_its_place_with_the_reason) {
    report::FittedCurve failed{.name = "two points", .data = {}, .laws = {}, .failure = {}};
    failed.failure = "2 usable points cannot determine 3 parameters";
    const std::string page = page_of({fitted("good", {"bingham"}), failed});
    EXPECT_GE(count(page, "2 usable points cannot determine"), 1U);
    EXPECT_EQ(drawings_in(page).size(), 2U);
}

// Through an instrument: the converted points, the inversion with its band, the torque's residuals,
// and what the conventional route gives.
TEST(FitPage, a_fit_through_an_instrument_shows_the_inversion_and_the_conventional_route) {
    report::FittedCurve curve = fitted("din", {"herschel-bulkley"});
    curve.laws.front().conventional = curve.laws.front().result.estimates;
    curve.laws.front().conventional[0].value = 6.25;
    for (std::size_t k = 0; k < curve.data.size(); ++k) {
        const double rate = curve.data.rates[k];
        curve.rotor_points.push_back(
            {curve.data.stresses[k], k == 3 ? not_known : rate, 0.9 * rate, 1.1 * rate});
        curve.observed.push_back(1e-4 * curve.data.stresses[k]);
        curve.observed_rates.push_back(rate);
    }
    for (double& value : curve.laws.front().result.fitted)
        value *= 1e-4;
    curve.notes = {"c_L computed: 1.2 ... 1.25."};
    const std::string page = page_of({curve});
    for (const char* part :
         {"true rate at the rotor, no law", "95 % of that rate", "converted", "conventional route",
          "6.25", "1.2 ... 1.25", "torque: (fitted - measured)"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const std::string& drawing : drawings_in(page))
        EXPECT_EQ(markup_fault(drawing), "");
}

TEST(FitPage, many_curves_give_a_table_of_all_and_the_first_dozen_in_full) {
    const std::vector<report::FittedCurve> curves(15, fitted("curve", {"bingham"}));
    const std::string page = page_of(curves);
    EXPECT_EQ(drawings_in(page).size(), 24U);
    EXPECT_NE(page.find("15 curves"), std::string::npos);
}

} // namespace
