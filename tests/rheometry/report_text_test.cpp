#include "markup_check.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_path.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace searle::rheometry::report {
namespace {

TEST(report_text, markup_letters_are_escaped) {
    EXPECT_EQ(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    EXPECT_EQ(escaped("\u03b3\u0307 \u00b0"), "\u03b3\u0307 \u00b0");
}

TEST(report_text, bytes_that_are_no_utf8_and_control_letters_are_replaced) {
    EXPECT_EQ(escaped("a\xff"
                      "b"),
              "a\uFFFDb");
    EXPECT_EQ(escaped("\x01"), "\uFFFD");
    EXPECT_EQ(escaped("\xc0\xaf"), "\uFFFD\uFFFD");           // overlong '/'
    EXPECT_EQ(escaped("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD"); // a surrogate
    EXPECT_EQ(escaped("end\xe2\x82"), "end\uFFFD\uFFFD");     // cut in the middle
}

TEST(report_text, indices_come_back_to_the_line) {
    RichText text{"R"};
    text.subscript("bob").upright(" = 10").superscript("3");
    const std::string svg = text.svg(10.0);
    EXPECT_EQ(test::markup_fault(svg), "");
    EXPECT_EQ(svg,
              "R<tspan dy=\"2.2\" font-size=\"7.2px\">bob</tspan><tspan dy=\"-2.2\"> = 10</tspan>"
              "<tspan dy=\"-4.2\" font-size=\"7.2px\">3</tspan>");
}

TEST(report_text, shortened_text_fits_its_limit_and_keeps_whole_letters) {
    const RichText text{"\u03b7\u03b7\u03b7\u03b7\u03b7 a long name of a run"};
    for (double limit = 20.0; limit < 200.0; limit += 7.0) {
        const RichText cut = text.shortened(limit, 12.0);
        EXPECT_LE(cut.width(12.0), limit);
        EXPECT_EQ(cut.plain().find("\uFFFD"), std::string::npos);
    }
    EXPECT_EQ(text.shortened(1000.0, 12.0).plain(), text.plain());
}

TEST(report_text, numbers_have_the_digits_asked_for) {
    EXPECT_EQ(significant(1.0016e-3, 6), "0.0010016");
    EXPECT_EQ(significant(9.996, 3), "10");
    EXPECT_EQ(significant(-0.5, 3), "\u22120.5");
    EXPECT_EQ(significant(-0.0, 3), "0");
    EXPECT_EQ(significant(2173.4, 2), "2200");
    EXPECT_EQ(significant(123456.0, 9), "123456");
    EXPECT_EQ(significant(1.25e-11, 3), "1.25\u202f\u00d7\u202f10\u207b\u00b9\u00b9");
    EXPECT_EQ(significant(1e7, 3), "10\u2077");
    EXPECT_EQ(significant_padded(1.5, 4), "1.500");
    EXPECT_EQ(significant(std::numeric_limits<double>::quiet_NaN(), 3), "\u2013");
    EXPECT_EQ(significant(std::numeric_limits<double>::infinity(), 3), "\u2013");
}

TEST(report_text, values_keep_the_digits_that_their_error_leaves) {
    // Two digits of the error: 0.0031 leaves four decimals.
    EXPECT_EQ(rounded_to_error(12.3456789, 0.0031), "12.3457");
    EXPECT_EQ(rounded_to_error(12.3456789, 31.0), "12.3"); // never below three digits
    EXPECT_EQ(rounded_to_error(12.3456789, 0.0), "12.3456789");
    EXPECT_EQ(rounded_to_error(100.0, 0.01), "100.000");
}

TEST(report_text, units_take_the_prefix_that_suits) {
    EXPECT_EQ(quantity_text(1.0016e-3, "Pa.s"), "1.0016\u00a0mPa\u00a0s");
    EXPECT_EQ(quantity_text(5.2e-6, "N m"), "5.2\u00a0\u00b5N\u00a0m");
    EXPECT_EQ(quantity_text(0.014, "m"), "14\u00a0mm");
    EXPECT_EQ(quantity_text(0.00038, "m"), "0.38\u00a0mm");
    EXPECT_EQ(quantity_text(50e-6, "m"), "50\u00a0\u00b5m");
    EXPECT_EQ(quantity_text(1500.0, "Pa"), "1.5\u00a0kPa");
    EXPECT_EQ(quantity_text(1.0, "Pa"), "1\u00a0Pa");
    EXPECT_EQ(quantity_text(12000.0, "1/s"), "12000\u00a01/s");
    EXPECT_EQ(quantity_text(0.5, "Pa.s^n"), "0.5\u00a0Pa\u00a0s\u207f");
    EXPECT_EQ(quantity_text(998.2, "kg/m^3"), "998.2\u00a0kg/m\u00b3");
    EXPECT_EQ(quantity_text(0.5, "1"), "0.5");
}

TEST(report_text, a_column_shares_its_decimals_unless_it_spans_many_decades) {
    EXPECT_EQ(common_decimals(std::vector{0.35, 0.7, 7.0}), 2);
    EXPECT_EQ(common_decimals(std::vector{1.0, 2.0, 100.0}), 0);
    EXPECT_EQ(common_decimals(std::vector{0.0644444444, 6.4444444444}),
              6); // 7 digits of the largest
    EXPECT_EQ(common_decimals(std::vector{0.01, 1000.0}), std::nullopt);
    EXPECT_EQ(with_decimals(7.0, 2), "7.00");
    EXPECT_EQ(with_decimals(-0.001, 2), "0.00");
    EXPECT_EQ(with_decimals(-1.5, 1), "\u22121.5");
}

TEST(report_text, prose_sets_symbols_and_leaves_names_of_keys) {
    EXPECT_EQ(
        prose_html("Re / Re_c with c_L = 1, tau_0 = 5 Pa"),
        "Re / Re<sub>c</sub> with <i>c</i><sub>L</sub> = 1, <i>\u03c4</i><sub>0</sub> = 5 Pa");
    EXPECT_EQ(prose_html("eta^(3/4) and 10^-3, R^2"),
              "<i>\u03b7</i><sup>3/4</sup> and 10<sup>-3</sup>, R<sup>2</sup>");
    EXPECT_EQ(prose_html("end_factor, geometry.cup_radius, beta, fluid.eta, a ^ b^"),
              "end_factor, geometry.cup_radius, beta, fluid.eta, a ^ b^");
    EXPECT_EQ(prose_html("<b> & R_<i>"), "&lt;b&gt; &amp; R_&lt;i&gt;");
    EXPECT_EQ(prose_html("^(<b>)"), "<sup>&lt;b&gt;</sup>");
    EXPECT_EQ(prose_html("\u03b7 \u00b0C \xff"), "\u03b7 \u00b0C \uFFFD");
}

TEST(report_text, lengths_in_drawings_are_always_plain_numbers) {
    EXPECT_EQ(pixels(12.345), "12.35");
    EXPECT_EQ(pixels(-0.001), "0");
    EXPECT_EQ(pixels(-3.5), "-3.5");
    EXPECT_EQ(pixels(std::numeric_limits<double>::quiet_NaN()), "0");
    EXPECT_EQ(pixels(std::numeric_limits<double>::infinity()), "0");
    EXPECT_EQ(pixels(1e300), "1000000");
}

} // namespace
} // namespace searle::rheometry::report
