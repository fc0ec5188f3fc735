#include "casefile/toml_text.hpp"

#include <gtest/gtest.h>
#include <string>

using namespace searle::casefile;

namespace {

ParsedToml parse(const std::string& text) {
    return parse_toml(text, Source::of_file("case.toml", text));
}

} // namespace

TEST(toml_text, values_know_their_places) {
    const ParsedToml parsed = parse("title = \"x\"\n[geometry]\n  bob_radius = \"14 mm\" # note\n");
    ASSERT_TRUE(parsed.faults.empty());
    const Entry* section = parsed.root.find("geometry");
    ASSERT_NE(section, nullptr);
    EXPECT_EQ(section->value.place.line, 2);
    const Entry* radius = section->value.find("bob_radius");
    ASSERT_NE(radius, nullptr);
    EXPECT_EQ(radius->key_place.line, 3);
    EXPECT_EQ(radius->key_place.column, 3);
    EXPECT_EQ(radius->value.place.column, 16);
    EXPECT_EQ(radius->value.place.length, 7);
    EXPECT_EQ(radius->value.text, "14 mm");
}

TEST(toml_text, entries_keep_the_order_of_the_file) {
    const ParsedToml parsed = parse("b = 1\na = 2\n[z]\n[y]\n");
    std::string order;
    for (const Entry& entry : parsed.root.entries)
        order += entry.key;
    EXPECT_EQ(order, "bazy");
}

TEST(toml_text, all_faulty_lines_are_reported_in_one_go) {
    const ParsedToml parsed = parse("a = 14 mm\nb = \"x\nc = 3\nc = 4\nd = steady\ne = 5\n");
    ASSERT_EQ(parsed.faults.size(), 4U);
    EXPECT_EQ(parsed.faults[0].places.front().line, 1);
    EXPECT_NE(parsed.faults[0].problem.find("stand in quotes"), std::string::npos);
    EXPECT_EQ(parsed.faults[0].suggestion, "a = \"14 mm\"");
    EXPECT_EQ(parsed.faults[1].places.front().line, 2);
    EXPECT_NE(parsed.faults[1].problem.find("not closed"), std::string::npos);
    EXPECT_EQ(parsed.faults[2].places.front().line, 4);
    EXPECT_EQ(parsed.faults[2].problem, "c is given twice, first on line 3");
    EXPECT_EQ(parsed.faults[3].places.front().line, 5);
    EXPECT_NE(parsed.root.find("e"), nullptr) << "the rest of the file is read";
    EXPECT_NE(parsed.root.find("c"), nullptr);
}

TEST(toml_text, section_given_twice_names_both_lines) {
    const ParsedToml parsed = parse("[fluid]\na = 1\n[other]\n[fluid]\nb = 2\n");
    ASSERT_EQ(parsed.faults.size(), 1U);
    EXPECT_EQ(parsed.faults[0].problem,
              "fluid is given twice, first on line 1; the file is read up to here only");
    EXPECT_EQ(parsed.faults[0].places.at(0).line, 4);
    EXPECT_EQ(parsed.faults[0].places.at(1).line, 1);
    EXPECT_NE(parsed.root.find("fluid"), nullptr) << "what stands before is read";
}

TEST(toml_text, what_is_no_toml_is_a_fault_with_its_line) {
    for (const char* text : {"[geometry\na = 1\n", "hello world\n", "= 3\n", "a = [1, 2\n",
                             "a = {b = 1\n", "\xff\xfe\n", "a = \"\xc3\x28\"\n", "a\n"}) {
        const ParsedToml parsed = parse(text);
        ASSERT_FALSE(parsed.faults.empty()) << text;
        EXPECT_GE(parsed.faults.front().places.front().line, 1) << text;
        EXPECT_NE(parsed.faults.front().text().find("case.toml:"), std::string::npos);
    }
}

TEST(toml_text, endless_nesting_is_refused) {
    std::string key = "a";
    for (int depth = 0; depth < 200000; ++depth)
        key += ".a";
    EXPECT_FALSE(parse(key + " = 1\n").faults.empty());
    EXPECT_FALSE(parse("x = {" + key + " = 1}\n").faults.empty());
    EXPECT_FALSE(parse("[" + key + "]\n").faults.empty());
    EXPECT_FALSE(parse("a = " + std::string(100000, '[') + "\n").faults.empty());
    EXPECT_TRUE(parse("a = \"" + std::string(1000, '.') + "\"\n").faults.empty());
    EXPECT_TRUE(parse("a = [" + std::string("1.5, ") + "2.5]\n").faults.empty());
}

TEST(toml_text, byte_order_mark_and_crlf_are_taken) {
    const ParsedToml parsed = parse("\xef\xbb\xbf[a]\r\nb = 1\r\n");
    EXPECT_TRUE(parsed.faults.empty());
    ASSERT_NE(parsed.root.find("a"), nullptr);
    EXPECT_EQ(parsed.root.find("a")->value.find("b")->key_place.line, 2);
}
