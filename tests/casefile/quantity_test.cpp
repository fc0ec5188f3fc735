#include "casefile/quantity.hpp"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace searle;
using casefile::Quantity;
using casefile::QuantityFault;
using casefile::QuantityKind;

namespace {

double value(const std::string& text, const QuantityKind& kind) {
    const auto parsed = casefile::parse_quantity(text, std::vector{kind});
    const auto* quantity = std::get_if<Quantity>(&parsed);
    return quantity ? quantity->value : std::numeric_limits<double>::quiet_NaN();
}

QuantityFault fault(const std::string& text, const QuantityKind& kind) {
    const auto parsed = casefile::parse_quantity(text, std::vector{kind});
    const auto* found = std::get_if<QuantityFault>(&parsed);
    return found ? *found : QuantityFault{"", ""};
}

struct Conversion {
    std::string text;
    QuantityKind kind;
    double si;
};

} // namespace

// Expected values: the definitions of the units, written out by hand.
TEST(quantity, common_units_convert_exactly) {
    const std::vector<Conversion> conversions{
        {"14 mm", casefile::length, 0.014},
        {"14mm", casefile::length, 0.014},
        {"20.38 mm", casefile::length, 0.02038},
        {" 1.5 um ", casefile::length, 1.5e-6},
        {"1.5 \u00b5m", casefile::length, 1.5e-6},
        {"1.5 \u03bcm", casefile::length, 1.5e-6},
        {"1 inch", casefile::length, 0.0254},
        {"1.0016 mPa.s", casefile::viscosity, 1.0016e-3},
        {"1.0016 mPa s", casefile::viscosity, 1.0016e-3},
        {"1.0016 mPa\u00b7s", casefile::viscosity, 1.0016e-3},
        {"1.0016 mPa*s", casefile::viscosity, 1.0016e-3},
        {"1.0016 mPas", casefile::viscosity, 1.0016e-3},
        {"1.0016 cP", casefile::viscosity, 1.0016e-3},
        {"2 P", casefile::viscosity, 0.2},
        {"1e-3 Pa.s", casefile::viscosity, 1e-3},
        {"998.2 kg/m^3", casefile::density, 998.2},
        {"998.2 kg/m3", casefile::density, 998.2},
        {"998.2 kg/m\u00b3", casefile::density, 998.2},
        {"998.2 kg.m^-3", casefile::density, 998.2},
        {"998.2 kg m\u207b\u00b3", casefile::density, 998.2},
        {"0.9982 g/cm^3", casefile::density, 998.2},
        {"5 Pa", casefile::stress, 5.0},
        {"50 dyn/cm^2", casefile::stress, 5.0},
        {"100 1/s", casefile::shear_rate, 100.0},
        {"100 s^-1", casefile::shear_rate, 100.0},
        {"100 s-1", casefile::shear_rate, 100.0},
        {"100 /s", casefile::shear_rate, 100.0},
        {"100 s\u207b\u00b9", casefile::shear_rate, 100.0},
        {"-100 1/s", casefile::shear_rate, -100.0},
        {"35 s", casefile::duration, 35.0},
        {"0.5 min", casefile::duration, 30.0},
        {"2 h", casefile::duration, 7200.0},
        {"250 ms", casefile::duration, 0.25},
        {"10 rad/s", casefile::angular_velocity, 10.0},
        {"30 rpm", casefile::angular_velocity, std::numbers::pi},
        {"30 rev/min", casefile::angular_velocity, std::numbers::pi},
        {"30 r/min", casefile::angular_velocity, std::numbers::pi},
        {"30 U/min", casefile::angular_velocity, std::numbers::pi},
        {"30 1/min", casefile::angular_velocity, std::numbers::pi},
        {"30 min^-1", casefile::angular_velocity, std::numbers::pi},
        {"0.5 rev/s", casefile::angular_velocity, std::numbers::pi},
        {"180 deg/s", casefile::angular_velocity, std::numbers::pi},
        {"180 deg", casefile::angle, std::numbers::pi},
        {"180\u00b0", casefile::angle, std::numbers::pi},
        {"1 rad", casefile::angle, 1.0},
        {"1 mm/s", casefile::speed, 1e-3},
        {"20 degC", casefile::temperature, 293.15},
        {"20 \u00b0C", casefile::temperature, 293.15},
        {"293.15 K", casefile::temperature, 293.15},
        {"68 degF", casefile::temperature, 293.15},
        {"32 mV", casefile::voltage, 0.032},
        {"6e-20 J", casefile::energy, 6e-20},
        {"1e-2 N/m", casefile::spring_stiffness, 0.01},
        {"1 mM", casefile::concentration, 1.0},
        {"1 mol/l", casefile::concentration, 1000.0},
        {"0.1 %", casefile::fraction, 1e-3},
        {".5 m", casefile::length, 0.5},
        {"5. m", casefile::length, 5.0},
        {"+5 m", casefile::length, 5.0},
        {"1E-3 m", casefile::length, 1e-3},
    };
    for (const Conversion& conversion : conversions)
        EXPECT_NEAR(value(conversion.text, conversion.kind), conversion.si,
                    2e-15 * std::abs(conversion.si))
            << conversion.text;
}

// A power of ten in the unit must not cost a rounding: the result is the double nearest to the
// decimal.
TEST(quantity, decimal_prefixes_give_the_nearest_double) {
    EXPECT_EQ(value("20.38 mm", casefile::length), 0.02038);
    EXPECT_EQ(value("22.38 mm", casefile::length), 0.02238);
    EXPECT_EQ(value("1.0016 mPa.s", casefile::viscosity), 0.0010016);
    EXPECT_EQ(value("0.1 %", casefile::fraction), 0.001);
    EXPECT_EQ(value("14.7 um", casefile::length), 14.7e-6);
    EXPECT_EQ(value("120 deg", casefile::angle), 2.0943951023931953);
}

TEST(quantity, consistency_has_a_rule_of_its_own) {
    EXPECT_EQ(value("0.5 Pa.s^n", casefile::consistency), 0.5);
    EXPECT_EQ(value("500 mPa.s^n", casefile::consistency), 0.5);
    EXPECT_EQ(value("0.5 Pa s^n", casefile::consistency), 0.5);
    EXPECT_EQ(value("0.5 Pa\u00b7s\u207f", casefile::consistency), 0.5);
    EXPECT_EQ(value("0.5 Pas^n", casefile::consistency), 0.5);
    EXPECT_EQ(value("0.5 kPa*s^n", casefile::consistency), 500.0);
    // 1 lbf/ft^2 = 4.4482216152605 N / 0.3048^2 m^2.
    EXPECT_NEAR(value("1 lbf.s^n/ft^2", casefile::consistency), 4.4482216152605 / (0.3048 * 0.3048),
                1e-12);
}

TEST(quantity, a_number_as_the_power_of_a_consistency_is_told_to_be_n) {
    for (const auto& [written, meant] :
         {std::pair{"1 Pa.s^0.35", "Pa.s^n"}, std::pair{"1 mPa*s**0.5", "mPa*s**n"},
          std::pair{"1 lbf.s^0.7/ft^2", "lbf.s^n/ft^2"}}) {
        const QuantityFault number = fault(written, casefile::consistency);
        EXPECT_EQ(number.suggestion, meant);
        EXPECT_NE(number.problem.find("flow_index"), std::string::npos);
    }
    for (const char* written : {"1 m.s^0.35", "1 Pa.s^", "1 Pa.s^x", "1 s^0.5"})
        EXPECT_EQ(fault(written, casefile::consistency).suggestion, "") << written;
}

TEST(quantity, viscosity_unit_is_refused_for_a_consistency) {
    const QuantityFault plain = fault("0.5 Pa.s", casefile::consistency);
    EXPECT_NE(plain.problem.find("of a viscosity"), std::string::npos) << plain.problem;
    EXPECT_EQ(plain.suggestion, "Pa.s^n");
    EXPECT_NE(fault("0.5 Pa", casefile::consistency).problem, "");
    EXPECT_NE(fault("0.5 m.s^n", casefile::consistency).problem, "");
    EXPECT_NE(fault("0.5 s^n", casefile::consistency).problem, "");
    EXPECT_NE(fault("0.5", casefile::consistency).problem, "");
}

TEST(quantity, number_without_a_unit_is_refused) {
    EXPECT_EQ(fault("14", casefile::length).problem, "has no unit");
    EXPECT_EQ(fault("", casefile::length).problem, "is empty");
}

TEST(quantity, wrong_dimension_is_named) {
    EXPECT_EQ(fault("14 s", casefile::length).problem, "is a time");
    EXPECT_EQ(fault("1 m/s", casefile::length).problem, "is a speed");
    EXPECT_EQ(fault("1 mm^2/s", casefile::viscosity).problem, "is a kinematic viscosity");
    EXPECT_EQ(fault("1 cSt", casefile::viscosity).problem, "is a kinematic viscosity");
    EXPECT_EQ(fault("1 m^7", casefile::length).problem, "has the wrong unit");
}

TEST(quantity, angular_velocity_is_not_a_shear_rate) {
    EXPECT_EQ(fault("10 rad/s", casefile::shear_rate).problem, "is an angular velocity");
    EXPECT_EQ(fault("10 rpm", casefile::shear_rate).problem, "is an angular velocity");
    EXPECT_EQ(fault("10 1/s", casefile::angular_velocity).problem, "is a shear rate");
    const std::vector<QuantityKind> both{casefile::shear_rate, casefile::angular_velocity};
    EXPECT_EQ(std::get<Quantity>(casefile::parse_quantity("10 1/s", both)).kind, 0U);
    EXPECT_EQ(std::get<Quantity>(casefile::parse_quantity("10 rpm", both)).kind, 1U);
}

TEST(quantity, hertz_is_ambiguous) {
    EXPECT_NE(fault("10 Hz", casefile::shear_rate).problem.find("Hz"), std::string::npos);
    EXPECT_NE(fault("10 kHz", casefile::shear_rate).problem.find("Hz"), std::string::npos);
}

TEST(quantity, numbers_that_are_not_finite_are_refused) {
    for (const char* text :
         {"nan m", "inf m", "-inf m", "NaN m", "Infinity m", "1e400 m", "1e99999999999 m",
          "1e308 Tm", "m", "mm 14", "--1 m", "1,5 mm", "1 000 mm", "1e m", "0x10 m"})
        EXPECT_NE(fault(text, casefile::length).problem, "") << text;
    EXPECT_NE(fault("1,5 mm", casefile::length).problem.find("point"), std::string::npos);
    EXPECT_EQ(value("0e99999999999 m", casefile::length), 0.0);
}

TEST(quantity, numbers_inside_units_are_refused) {
    for (const char* text : {"14 000 mm", "14 2 mm", "14 m/60", "14 1.5mm", "14 m 2"})
        EXPECT_NE(fault(text, casefile::length).problem, "") << text;
}

TEST(quantity, nearest_unit_is_suggested) {
    EXPECT_EQ(fault("14 mmm", casefile::length).suggestion, "mm");
    EXPECT_EQ(fault("35 sx", casefile::duration).suggestion, "s");
    EXPECT_EQ(fault("1 mPa.ss", casefile::viscosity).suggestion, "mPa.s");
    EXPECT_EQ(fault("14 parsnips", casefile::length).suggestion, "");
}

TEST(quantity, si_text_reads_back_to_the_same_bits) {
    std::mt19937_64 random{20260101};
    const std::vector<QuantityKind> kinds{casefile::length,           casefile::viscosity,
                                          casefile::shear_rate,       casefile::consistency,
                                          casefile::angular_velocity, casefile::temperature,
                                          casefile::concentration};
    int compared = 0;
    for (int draw = 0; draw < 20000; ++draw) {
        double number{};
        const std::uint64_t bits = random();
        static_assert(sizeof(number) == sizeof(bits));
        std::memcpy(&number, &bits, sizeof number);
        if (!std::isfinite(number))
            continue;
        const QuantityKind& kind = kinds[static_cast<std::size_t>(draw) % kinds.size()];
        ASSERT_EQ(value(casefile::si_text(number, kind), kind), number)
            << casefile::si_text(number, kind);
        ++compared;
    }
    EXPECT_GT(compared, 19000);
    EXPECT_EQ(casefile::si_text(0.014, casefile::length), "0.014 m");
    EXPECT_EQ(casefile::si_text(1e-3, casefile::fraction), "0.001");
}

TEST(quantity, random_texts_never_crash) {
    std::mt19937 random{7};
    const std::string signs = "0123456789.-+eE mPasn^/()*\u00b5\u00b2@%";
    for (int draw = 0; draw < 20000; ++draw) {
        std::string text;
        for (auto length = random() % 12; length > 0; --length)
            text += signs[random() % signs.size()];
        for (const QuantityKind& kind : {casefile::length, casefile::consistency}) {
            const auto parsed = casefile::parse_quantity(text, std::vector{kind});
            if (const auto* quantity = std::get_if<Quantity>(&parsed)) {
                EXPECT_TRUE(std::isfinite(quantity->value)) << text;
            }
        }
    }
}
