#include "casefile/fault.hpp"

#include <gtest/gtest.h>

using namespace searle::casefile;

TEST(fault, text_shows_place_excerpt_caret_allowed_and_suggestion) {
    const auto source = Source::of_file("water.toml", "first\nbob_radius = 14\n");
    const Fault fault{
        {{source, 2, 14, 2}}, "geometry.bob_radius", "14 has no unit", "a length", "x"};
    EXPECT_EQ(fault.text(), "water.toml:2:14: geometry.bob_radius: 14 has no unit\n"
                            "    2 | bob_radius = 14\n"
                            "      |              ^^\n"
                            "      = allowed: a length\n"
                            "      = did you mean x?");
}

TEST(fault, override_stands_in_place_of_a_line) {
    const Fault fault{{{Source::of_override("a.b=3"), 1, 5, 1}}, "a.b", "3 is wrong", "", ""};
    EXPECT_EQ(fault.text(), "--set a.b=3: a.b: 3 is wrong\n"
                            "      | a.b=3\n"
                            "      |     ^");
}

TEST(fault, caret_counts_characters_not_bytes) {
    const auto source = Source::of_file("f", "title = \"\u00e4\u00f6\" x\n");
    const Fault fault{{{source, 1, 14, 1}}, "", "no", "", ""};
    EXPECT_NE(fault.text().find("\n      |              ^"), std::string::npos) << fault.text();
}

TEST(fault, long_lines_are_clipped_around_the_place) {
    const std::string line = std::string(5000, 'a') + "X" + std::string(5000, 'b');
    const Fault fault{{{Source::of_file("f", line), 1, 5001, 1}}, "", "no", "", ""};
    EXPECT_LT(fault.text().size(), 400U);
    EXPECT_NE(fault.text().find("aX"), std::string::npos);
}

TEST(fault, control_signs_do_not_reach_the_terminal) {
    const Fault fault{{{Source::of_file("f", "a\x1b[31m"), 1, 1, 1}}, "", "no", "", ""};
    EXPECT_EQ(fault.text().find('\x1b'), std::string::npos);
}

TEST(fault, places_outside_the_text_are_harmless) {
    const auto source = Source::of_file("f", "short\n");
    for (const Place& place : {Place{source, 0, 0, 1}, Place{source, 1, 900, 900},
                               Place{source, 99, 1, 1}, Place{source, 1, 0, 0}})
        EXPECT_NE((Fault{{place}, "", "no", "", ""}.text()).find("no"), std::string::npos);
}

TEST(case_error, faults_come_in_the_order_of_the_file_and_are_counted) {
    const auto source = Source::of_file("f", "a\nb\nc\n");
    const CaseError error{{{{{source, 3, 1, 1}}, "", "third", "", ""},
                           {{{source, 1, 1, 1}}, "", "first", "", ""},
                           {{{Source::of_override("x"), 1, 1, 1}}, "", "last", "", ""}}};
    const std::string text = error.what();
    EXPECT_LT(text.find("first"), text.find("third"));
    EXPECT_LT(text.find("third"), text.find("last"));
    EXPECT_TRUE(text.ends_with("3 faults"));
}

TEST(case_error, thousands_of_faults_are_counted_not_all_shown) {
    const auto source = Source::of_file("f", "a\n");
    const CaseError error{std::vector<Fault>(5000, Fault{{{source, 1, 1, 1}}, "", "no", "", ""})};
    EXPECT_LT(std::string{error.what()}.size(), 10000U);
    EXPECT_NE(std::string{error.what()}.find("5000 faults"), std::string::npos);
}
