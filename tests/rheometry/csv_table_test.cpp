#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_columns.hpp"
#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

namespace searle::rheometry {
namespace {

std::vector<double> column(const std::string& text, std::string_view name) {
    const CsvTable table = CsvTable::parse(text, "lab.csv");
    NumberColumns numbers(table);
    std::vector<double> values = numbers.read(table.find(name).value(), MissingValues::forbidden);
    numbers.faults().throw_if_any();
    return values;
}

/// The message of the error that reading both columns gives; empty without one.
std::string message_of(const std::string& text) {
    try {
        (void)column(text, "a");
        (void)column(text, "b");
    } catch (const TableError& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

const std::vector<double> expected_b{2.5, -4e-3};

TEST(csv_table, comma_semicolon_and_tab_are_found) {
    for (const char delimiter : {',', ';', '\t'}) {
        std::string text = "a,b\n1,2.5\n3,-4e-3\n";
        std::ranges::replace(text, ',', delimiter);
        EXPECT_EQ(column(text, "b"), expected_b);
        EXPECT_EQ(CsvTable::parse(text, "x").delimiter(), delimiter);
    }
}

TEST(csv_table, spreadsheets_own_choice_of_delimiter_is_taken) {
    EXPECT_EQ(column("sep=;\na;b\n1;2.5\n3;-4e-3\n", "b"), expected_b);
}

TEST(csv_table, decimal_commas_are_read) {
    EXPECT_EQ(column("a;b\n1;2,5\n3;-4e-3\n", "b"), expected_b);
    EXPECT_EQ(column("a\tb\n1\t2,5\n3\t-0,004\n", "b"), expected_b);
    EXPECT_EQ(column("a,b\n1,\"2,5\"\n3,\"-0,004\"\n", "b"), expected_b);
}

TEST(csv_table, every_line_ending_is_read) {
    for (const std::string ending : {"\n", "\r\n", "\r"}) {
        const std::string text = "a,b" + ending + "1,2.5" + ending + "3,-4e-3";
        EXPECT_EQ(column(text, "b"), expected_b);
        EXPECT_EQ(column(text + ending + ending, "b"), expected_b);
        EXPECT_EQ(CsvTable::parse(text, "x").line(1), 3U);
    }
}

std::string utf16(const std::u16string& text, bool little, bool mark) {
    std::string bytes;
    for (const char16_t unit : (mark ? u"\uFEFF" : u"") + text) {
        const char low = static_cast<char>(unit & 0xFF);
        const char high = static_cast<char>(unit >> 8);
        bytes += little ? low : high;
        bytes += little ? high : low;
    }
    return bytes;
}

TEST(csv_table, every_encoding_is_read) {
    EXPECT_EQ(column("\xEF\xBB\xBF"
                     "a,b\n1,2.5\n3,-4e-3\n",
                     "b"),
              expected_b);
    for (const bool little : {true, false})
        for (const bool mark : {true, false})
            EXPECT_EQ(column(utf16(u"a;b\r\n1;2,5\r\n3;-0,004\r\n", little, mark), "b"),
                      expected_b);
    const std::string greek = "\xCE\xBC"; // U+03BC in UTF-8
    EXPECT_TRUE(CsvTable::parse(utf16(u"\u03BC,b\n1,2\n", true, true), "x").find(greek));
    const std::string micro = "\xC2\xB5"; // U+00B5 in UTF-8
    EXPECT_TRUE(CsvTable::parse("\xB5,b\n1,2\n", "x").find(micro)) << "Windows-1252";
    const std::string music = "\xF0\x9D\x84\x9E"; // U+1D11E, a surrogate pair in UTF-16
    EXPECT_TRUE(CsvTable::parse(utf16(u"\U0001D11E,b\n1,2\n", false, true), "x").find(music));
}

TEST(csv_table, broken_utf16_and_binary_files_are_refused) {
    EXPECT_TRUE(contains(message_of(utf16(u"a,b\n1,2\n", true, true) + "x"), "UTF-16"));
    EXPECT_TRUE(contains(message_of(std::string("\xFF\xFE\x00\xD8,\x00", 6)), "UTF-16"));
    EXPECT_TRUE(contains(message_of(std::string("a,b\n1,\0\0\0 2\n", 12)), "not a text file"));
}

TEST(csv_table, quoted_fields_follow_rfc_4180) {
    const CsvTable table =
        CsvTable::parse("\"a, with \"\"quotes\"\"\",\"two\nlines\"\n1, \"2\" \n", "x");
    EXPECT_EQ(table.columns()[0].name, "a, with \"quotes\"");
    EXPECT_EQ(table.columns()[1].name, "two\nlines");
    EXPECT_EQ(table.text(0, 1), "2");
    EXPECT_EQ(table.line(0), 3U);
}

TEST(csv_table, comments_and_empty_lines_are_skipped_and_counted) {
    const CsvTable table = CsvTable::parse("# lab 3\n\na,b\n# first\n1,2\n \n3,4\n", "x");
    EXPECT_EQ(table.header_line(), 3U);
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.line(0), 5U);
    EXPECT_EQ(table.line(1), 7U);
}

TEST(csv_table, a_line_of_units_is_no_data) {
    const CsvTable table = CsvTable::parse("time,torque\n[s],(mN.m)\n1,2\n", "x");
    EXPECT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.columns()[0].unit, "s");
    EXPECT_EQ(table.columns()[1].unit, "mN.m");
}

TEST(csv_table, empty_fields_at_the_end_of_a_row_do_not_count) {
    EXPECT_EQ(column("a,b,,\n1,2.5,\n3,-4e-3,,,\n", "b"), expected_b);
}

TEST(csv_table, faults_name_file_line_column_value_and_what_is_allowed) {
    const std::string message = message_of("a,b\n1,2\nx7,3\n");
    EXPECT_TRUE(message.starts_with("lab.csv:3: column \"a\": \"x7\" is not a number; allowed: "))
        << message;
}

TEST(csv_table, what_is_no_number_is_refused) {
    for (const char* wrong : {"abc", "1.2.3", "1 2", "0x10", "1e", "--1", "+-1", "1,234.5", "12 Pa",
                              "nan", "inf", "-Infinity", "1e999", "\"\"", "1_000"}) {
        const std::string message = message_of(std::string("a;b\n") + wrong + ";2\n");
        EXPECT_TRUE(contains(message, "lab.csv:2: column \"a\"")) << wrong << ": " << message;
    }
}

TEST(csv_table, mixed_decimal_marks_are_refused) {
    EXPECT_TRUE(contains(message_of("a;b\n1.5;2\n2,5;3\n"), "line 2 has a decimal point"));
}

TEST(csv_table, all_faults_are_told_at_once_but_not_without_end) {
    std::string text = "a,b\n";
    for (int row = 0; row < 100; ++row)
        text += "x,1\n";
    try {
        (void)column(text, "a");
        FAIL() << "no error";
    } catch (const TableError& error) {
        EXPECT_EQ(error.faults().size(), 20U);
        EXPECT_TRUE(contains(error.what(), "and 80 more"));
    }
}

TEST(csv_table, ragged_rows_are_refused_and_decimal_commas_hinted_at) {
    EXPECT_TRUE(contains(message_of("a,b\n1,2\n1,2,3\n"), "lab.csv:3: 3 fields"));
    EXPECT_TRUE(contains(message_of("a,b\n1\n"), "1 fields, but the header (line 1) has 2"));
    EXPECT_TRUE(contains(message_of("a,b\n0,1,0,2\n"), "decimal commas"));
}

TEST(csv_table, broken_quotes_are_refused_with_their_line) {
    EXPECT_TRUE(message_of("a,b\n1,\"2\n3,4\n").starts_with("lab.csv:2: a quote opens here"));
    EXPECT_TRUE(message_of("a,b\n1,\"2\"x\n").starts_with("lab.csv:2: text follows"));
    EXPECT_TRUE(message_of("a,b\n1,2\"\n").starts_with("lab.csv:2: a quote inside"));
}

TEST(csv_table, files_without_header_or_rows_are_refused) {
    EXPECT_TRUE(contains(message_of(""), "holds no data"));
    EXPECT_TRUE(contains(message_of("# nothing\n\n"), "holds no data"));
    EXPECT_TRUE(contains(message_of("a,b\n"), "no rows"));
    EXPECT_TRUE(contains(message_of("1,2\n3,4\n"), "must be the header"));
    EXPECT_TRUE(contains(message_of("a,a\n1,2\n"), "the same name"));
}

TEST(csv_table, directories_and_missing_files_are_refused) {
    EXPECT_THROW((void)CsvTable::read(std::filesystem::temp_directory_path()), TableError);
    EXPECT_THROW((void)CsvTable::read("no/such/file.csv"), TableError);
}

TEST(csv_table, numbers_written_read_back_bit_by_bit) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value) || std::fpclassify(value) == FP_SUBNORMAL)
            continue;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read_number(number_text(value)).value),
                  std::bit_cast<std::uint64_t>(value));
    }
}

// Nothing but an error may come out of damaged text.
TEST(csv_table, random_bytes_do_no_harm) {
    std::mt19937 random(5);
    const std::string alphabet = "a1,;\t\"\n\r# .e-+\xB5\xFF";
    for (int repeat = 0; repeat < 20000; ++repeat) {
        std::string text;
        const std::size_t length = random() % 40;
        while (text.size() < length)
            text += alphabet[random() % alphabet.size()];
        try {
            const CsvTable table = CsvTable::parse(text, "x");
            NumberColumns numbers(table);
            for (std::size_t i = 0; i < table.columns().size(); ++i)
                EXPECT_EQ(numbers.read(i, MissingValues::allowed).size(), table.rows());
        } catch (const TableError&) {
        }
    }
}

// 300 000 columns: comparing each with each takes minutes.
TEST(csv_table, a_header_of_many_columns_is_read_in_linear_time) {
    std::string header = "a";
    std::string row = "1";
    for (int k = 0; k < 300'000; ++k) {
        header += ",c" + std::to_string(k);
        row += ",2";
    }
    EXPECT_EQ(CsvTable::parse(header + '\n' + row + '\n', "wide.csv").columns().size(), 300'001U);
    EXPECT_TRUE(contains(message_of(header + ",a\n" + row + ",3\n"), "same name"));
}

} // namespace
} // namespace searle::rheometry
