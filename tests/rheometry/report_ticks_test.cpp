#include "rheometry/report/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <string>

namespace searle::rheometry::report {
namespace {

// A label read back as a number: "−2.5×10^4", "10^−3", "0.25".
double read_label(std::string label) {
    const auto replace = [&](std::string_view what, std::string_view by) {
        for (std::size_t at = label.find(what); at != std::string::npos; at = label.find(what)) {
            label.replace(at, what.size(), by);
        }
    };
    replace("\u2212", "-");
    replace("\u00d710^", "e");
    if (const std::size_t power = label.find("10^"); power != std::string::npos) {
        label.replace(power, 3, "1e");
    }
    return std::strtod(label.c_str(), nullptr);
}

void expect_labels_name_their_values(const TickMarks& ticks) {
    std::set<std::string> labels;
    for (const Tick& tick : ticks.major) {
        const std::string label = tick.label.plain();
        EXPECT_TRUE(labels.insert(label).second) << "twice: " << label;
        EXPECT_NE(label, "-0");
        EXPECT_NE(label, "\u22120");
        EXPECT_NEAR(read_label(label), tick.value, 1e-6 * std::abs(tick.value)) << label;
    }
}

TEST(report_ticks, linear_ticks_are_few_inside_the_range_and_equally_spaced) {
    std::mt19937_64 random{20250120};
    std::uniform_real_distribution<double> centre{-3.0, 3.0};
    std::uniform_real_distribution<double> exponent{-12.0, 9.0};
    std::uniform_int_distribution<int> count{5, 9};
    for (int trial = 0; trial < 3000; ++trial) {
        const double span = std::pow(10.0, exponent(random));
        const double low = span * centre(random);
        const double high = low + span;
        const int most = count(random);
        const TickMarks ticks = linear_ticks(low, high, most);
        ASSERT_GE(ticks.major.size(), 2u) << low << " " << high;
        ASSERT_LE(ticks.major.size(), static_cast<std::size_t>(most)) << low << " " << high;
        const double step = ticks.major[1].value - ticks.major[0].value;
        for (std::size_t k = 0; k < ticks.major.size(); ++k) {
            EXPECT_GE(ticks.major[k].value, low - 1e-6 * span);
            EXPECT_LE(ticks.major[k].value, high + 1e-6 * span);
            if (k > 0) {
                EXPECT_NEAR(ticks.major[k].value - ticks.major[k - 1].value, step, 1e-6 * step);
            }
        }
        const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
        EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                    std::abs(mantissa - 5) < 1e-6)
            << mantissa;
        expect_labels_name_their_values(ticks);
    }
}

TEST(report_ticks, the_tick_at_zero_is_an_unsigned_zero) {
    const TickMarks ticks = linear_ticks(-0.3, 0.3, 7);
    int zeros = 0;
    for (const Tick& tick : ticks.major) {
        if (tick.value == 0.0) {
            ++zeros;
            EXPECT_FALSE(std::signbit(tick.value));
            EXPECT_EQ(tick.label.plain(), "0");
        }
    }
    EXPECT_EQ(zeros, 1);
}

TEST(report_ticks, labels_of_one_axis_have_equal_decimals) {
    const TickMarks ticks = linear_ticks(0.93, 1.16, 7);
    ASSERT_EQ(ticks.major.size(), 5u); // 0.95 ... 1.15 in steps of 0.05
    EXPECT_EQ(ticks.major.front().label.plain(), "0.95");
    EXPECT_EQ(ticks.major[1].label.plain(), "1.00");
}

TEST(report_ticks, decades_are_labelled_and_two_to_nine_are_minor) {
    const TickMarks ticks = logarithmic_ticks(0.9, 1.1e4, 8);
    ASSERT_EQ(ticks.major.size(), 5u); // 10^0 ... 10^4
    EXPECT_EQ(ticks.major[4].label.plain(), "10^4");
    EXPECT_EQ(ticks.minor.size(), 4u * 8u + 1u); // and 0.9
}

TEST(report_ticks, many_decades_label_every_few_powers) {
    const TickMarks ticks = logarithmic_ticks(1e-30, 1e30, 7);
    EXPECT_GE(ticks.major.size(), 4u);
    EXPECT_LE(ticks.major.size(), 7u);
    expect_labels_name_their_values(ticks);
}

TEST(report_ticks, any_logarithmic_range_has_at_least_two_labels) {
    std::mt19937_64 random{7};
    std::uniform_real_distribution<double> exponent{-9.0, 9.0};
    std::uniform_real_distribution<double> decades{0.01, 12.0};
    for (int trial = 0; trial < 3000; ++trial) {
        const double low = std::pow(10.0, exponent(random));
        const double high = low * std::pow(10.0, decades(random));
        const TickMarks ticks = logarithmic_ticks(low, high, 7);
        EXPECT_GE(ticks.major.size(), 2u) << low << " " << high;
        for (const Tick& tick : ticks.major) {
            EXPECT_GE(tick.value, low * (1.0 - 1e-6));
            EXPECT_LE(tick.value, high * (1.0 + 1e-6));
        }
        expect_labels_name_their_values(ticks);
    }
}

} // namespace
} // namespace searle::rheometry::report
