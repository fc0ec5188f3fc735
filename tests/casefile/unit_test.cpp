#include "casefile/common_units.hpp"
#include "casefile/unit.hpp"

#include "casefile/unit_spelling.hpp"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

using namespace searle;
using casefile::Unit;

namespace {

Unit unit(const std::string& text) {
    const auto found = casefile::unit_named(text);
    EXPECT_TRUE(std::holds_alternative<Unit>(found)) << text;
    return std::holds_alternative<Unit>(found) ? std::get<Unit>(found) : Unit{};
}

} // namespace

TEST(unit, dimensions_count_the_angle) {
    EXPECT_EQ(unit("mPa.s").dimension, (casefile::Dimension{.length = -1, .mass = 1, .time = -1}));
    EXPECT_EQ(unit("mN.m").dimension, (casefile::Dimension{.length = 2, .mass = 1, .time = -2}));
    EXPECT_EQ(unit("rad/s").dimension, (casefile::Dimension{.time = -1, .angle = 1}));
    EXPECT_EQ(unit("1/s").dimension, (casefile::Dimension{.time = -1}));
    EXPECT_EQ(unit("%").dimension, casefile::Dimension{});
    EXPECT_EQ(unit("V").dimension,
              (casefile::Dimension{.length = 2, .mass = 1, .time = -3, .current = -1}));
}

TEST(unit, powers_of_ten_stand_apart_from_the_factor) {
    EXPECT_EQ(unit("mN.m").decimal_exponent, -3);
    EXPECT_EQ(unit("mNm").decimal_exponent, -3);
    EXPECT_EQ(unit("uN.m").decimal_exponent, -6);
    EXPECT_EQ(unit("GPa").decimal_exponent, 9);
    EXPECT_EQ(unit("mN.m").factor, 1.0);
    EXPECT_EQ(unit("min").factor, 60.0);
    EXPECT_EQ(unit("degC").offset, 273.15);
}

TEST(unit, unknown_units_say_so) {
    for (const char* text : {"foo", "mm^", "m//s", "(m", "m)", "m) s", "@", "K @ 3", "dB(re 1 mW)",
                             "seconds since 2000-01-01", "000 mm", "m 2", "m, s", "m\"", "m#"})
        EXPECT_TRUE(std::holds_alternative<casefile::UnknownUnit>(casefile::unit_named(text)))
            << text;
}

// "kg·2" is a slip as "kg 2" is; the last ones make UDUNITS lose memory.
TEST(unit, numbers_that_are_no_powers_are_refused_in_any_spelling) {
    for (const char* text :
         {"60 s", "kg 2", "kg·2", "kg\u00a02", "kg*2", "kg -2", "m per 2", "m per2", "-10 m", "m^0",
          "m\u2070", "s0", "s-0m", "d\u00a00N", "P0.m", "m^-0foo"})
        EXPECT_TRUE(std::holds_alternative<casefile::UnknownUnit>(casefile::unit_named(text)))
            << text;
    for (const char* text :
         {"m2", "m-2", "m^-2", "m^10", "s⁻¹", "1/s", "kg·m²", "N-m", "mercury_0C"})
        EXPECT_TRUE(std::holds_alternative<Unit>(casefile::unit_named(text))) << text;
}

TEST(unit, spelling_touches_whole_names_only) {
    EXPECT_EQ(casefile::udunits_spelling("mPa.s"), "mPa.s");
    EXPECT_EQ(casefile::udunits_spelling("cP"), "(mPa.s)");
    EXPECT_EQ(casefile::udunits_spelling("cPa"), "cPa");
    EXPECT_EQ(casefile::udunits_spelling("m\u00b2/s"), "m^2/s");
    EXPECT_EQ(casefile::udunits_spelling("s\u207b\u00b9"), "s^-1");
}

TEST(unit, may_be_asked_for_by_several_threads) {
    std::vector<std::thread> threads;
    std::vector<int> right(8, 0);
    for (std::size_t at = 0; at < right.size(); ++at)
        threads.emplace_back([&right, at] {
            for (int again = 0; again < 200; ++again)
                if (std::holds_alternative<Unit>(casefile::unit_named(again % 2 ? "mm" : "rpm")))
                    ++right[at];
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const int count : right)
        EXPECT_EQ(count, 200);
}

// UDUNITS-2 is the authority for those that are known by heart, too.
TEST(unit, common_ones_are_those_of_the_database_bit_for_bit) {
    EXPECT_GE(casefile::common_units().size(), 20U);
    for (const auto& [name, known] : casefile::common_units()) {
        const auto found = casefile::unit_of_database(name);
        ASSERT_TRUE(std::holds_alternative<Unit>(found)) << name;
        const Unit& expected = std::get<Unit>(found);
        EXPECT_EQ(known.dimension, expected.dimension) << name;
        EXPECT_EQ(known.decimal_exponent, expected.decimal_exponent) << name;
        EXPECT_EQ(known.factor, expected.factor) << name;
        EXPECT_EQ(known.offset, expected.offset) << name;
    }
}
