#include "rheometry/tables/open_workbook.hpp"

#include "rheometry/tables/flow_curves.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "small_zip.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <unistd.h>

namespace searle::rheometry {
namespace {

class Workbook {
public:
    explicit Workbook(const std::string& bytes)
        : path_(std::filesystem::temp_directory_path() /
                ("searle_workbook_" + std::to_string(::getpid()) + ".xlsx")) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~Workbook() { std::filesystem::remove(path_); }
    Workbook(const Workbook&) = delete;
    Workbook& operator=(const Workbook&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

const std::string head = R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>)";
const std::string main_space =
    R"(xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main")";

/// A workbook of sheets with the given names and <sheetData>.
std::string workbook(const std::vector<std::pair<std::string, std::string>>& sheets,
                     const std::string& texts) {
    std::string list;
    std::string relations;
    std::vector<std::pair<std::string, std::string>> parts;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        list += "<sheet name=\"" + sheets[k].first + "\" sheetId=\"" + number + "\" r:id=\"rId" +
                number + "\"/>";
        relations += "<Relationship Id=\"rId" + number +
                     "\" Type=\"worksheet\" Target=\"worksheets/sheet" + number + ".xml\"/>";
        parts.emplace_back("xl/worksheets/sheet" + number + ".xml",
                           head + "<worksheet " + main_space + "><sheetData>" + sheets[k].second +
                               "</sheetData></worksheet>");
    }
    parts.emplace_back("xl/workbook.xml",
                       head + "<workbook " + main_space +
                           " xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/"
                           "relationships\"><sheets>" +
                           list + "</sheets></workbook>");
    parts.emplace_back("xl/_rels/workbook.xml.rels",
                       head + "<Relationships>" + relations + "</Relationships>");
    parts.emplace_back("xl/sharedStrings.xml",
                       head + "<sst " + main_space + ">" + texts + "</sst>");
    return test::zip_of(parts);
}

const std::string flow_texts = "<si><t>shear rate</t></si><si><t>shear stress</t></si>"
                               "<si><r><t>1/</t></r><r><t>s</t></r></si><si><t>Pa</t></si>";
const std::string flow_rows =
    R"(<row r="2"><c r="B2" t="s"><v>0</v></c><c r="C2" t="s"><v>1</v></c></row>)"
    R"(<row r="3"><c r="B3" t="s"><v>2</v></c><c r="C3" t="s"><v>3</v></c></row>)"
    R"(<row r="4"><c r="B4"><v>1</v></c><c r="C4"><v>5.5</v></c></row>)"
    R"(<row r="5"><c r="B5"><v>1E1</v></c><c r="C5"><f>C4*2</f><v>11</v></c></row>)";

TEST(OpenWorkbook, cells_are_where_their_references_say) {
    const Workbook file(workbook({{"Data", flow_rows}}, flow_texts));
    const std::vector<Sheet> sheets = read_open_workbook(file.path());
    ASSERT_EQ(sheets.size(), 1U);
    EXPECT_EQ(sheets[0].name, "Data");
    EXPECT_EQ(sheets[0].rows, 5U);
    EXPECT_EQ(sheets[0].columns, 3U);
    EXPECT_EQ(sheets[0].text(1, 1), "shear rate");
    EXPECT_EQ(sheets[0].text(2, 1), "1/s"); // runs of one text in two fonts
    EXPECT_EQ(std::get<double>(sheets[0].cell(3, 2)), 5.5);
    EXPECT_EQ(std::get<double>(sheets[0].cell(4, 2)), 11.0); // value of a formula
    EXPECT_TRUE(std::holds_alternative<std::monostate>(sheets[0].cell(0, 0)));
}

TEST(OpenWorkbook, inline_texts_and_cells_without_references_are_read) {
    const Workbook file(workbook(
        {{"A", R"(<row><c t="inlineStr"><is><t>a &amp; b</t></is></c><c><v>2</v></c></row>)"
               R"(<row><c t="str"><v>x</v></c></row>)"}},
        ""));
    const Sheet sheet = read_open_workbook(file.path()).front();
    EXPECT_EQ(sheet.text(0, 0), "a & b");
    EXPECT_EQ(std::get<double>(sheet.cell(0, 1)), 2.0);
    EXPECT_EQ(sheet.text(1, 0), "x");
}

TEST(OpenWorkbook, sheets_with_tables_are_flow_curves) {
    const Workbook file(
        workbook({{"first", flow_rows}, {"empty", ""}, {"second", flow_rows}}, flow_texts));
    const FlowCurveFile read = read_flow_curves(file.path());
    ASSERT_EQ(read.curves.size(), 2U);
    ASSERT_EQ(read.curves[0].points.size(), 2U);
    EXPECT_EQ(read.curves[0].points[1].rate, 10.0);
    EXPECT_EQ(read.curves[0].points[1].stress, 11.0);
}

// The layout of TRIOS: a sheet of details, and a sheet a step with title, headings, units, rows.
TEST(OpenWorkbook, exports_of_trios_are_steps) {
    const auto text = [](const std::string& words) {
        return "<c t=\"inlineStr\"><is><t>" + words + "</t></is></c>";
    };
    const std::string details = "<row>" + text("Bob diameter") + text("28.0 mm") + "</row>";
    const std::string step = "<row>" + text("Flow sweep - 1") + "</row><row>" + text("Torque") +
                             text("Velocity") + "</row><row>" + text("µN.m") + text("rad/s") +
                             "</row><row><c><v>250</v></c><c><v>2</v></c></row>"
                             "<row><c><v>300</v></c></row>";
    const Workbook file(workbook({{"Details", details}, {"Flow sweep - 1", step}}, ""));
    const MeasuredData data = read_measured_data(file.path(), DriveMotion::turning);
    ASSERT_EQ(data.steps.size(), 1U);
    ASSERT_TRUE(data.geometry.bob_radius);
    EXPECT_DOUBLE_EQ(*data.geometry.bob_radius, 0.014);
    // The second row has no velocity.
    ASSERT_EQ(data.steps[0].torque.size(), 1U);
    EXPECT_NEAR(data.steps[0].torque[0], 250e-6, 1e-18);
    ASSERT_EQ(data.remarks.size(), 1U);
    EXPECT_NE(data.remarks[0].find("1 of 2 rows left out"), std::string::npos);
}

std::string message_of(const std::string& bytes) {
    const Workbook file(bytes);
    try {
        (void)read_open_workbook(file.path());
    } catch (const TableError& error) {
        return error.what();
    }
    return "";
}

TEST(OpenWorkbook, what_is_no_workbook_is_refused_with_a_reason) {
    EXPECT_NE(message_of(test::zip_of({{"readme.txt", "hello"}})).find("no .xlsx workbook"),
              std::string::npos);
    EXPECT_NE(message_of("PK\x03\x04 rest").find("damaged"), std::string::npos);
    EXPECT_NE(
        message_of(workbook({{"A", R"(<row><c t="s"><v>7</v></c></row>)"}}, "")).find("text is"),
        std::string::npos);
    EXPECT_NE(
        message_of(workbook({{"A", R"(<row><c r="A1"><v>1,5</v></c></row>)"}}, "")).find("cell A1"),
        std::string::npos);
    EXPECT_NE(message_of(workbook({{"A", R"(<row><c r="!!"><v>1</v></c></row>)"}}, ""))
                  .find("is no cell"),
              std::string::npos);
    EXPECT_NE(message_of(workbook({{"A", "<row><c></row>"}}, "")).find("damaged at byte"),
              std::string::npos);
    EXPECT_NE(
        message_of(workbook({{"A", R"(<row><c r="A1"><v>1</v></c><c r="XFD1048576"><v>1</v></c>)"
                                   "</row>"}},
                            ""))
            .find("cells"),
        std::string::npos);
}

// Whatever is damaged, sheets or a TableError come out.
TEST(OpenWorkbook, damaged_workbooks_do_no_harm) {
    const std::string whole = workbook({{"Data", flow_rows}}, flow_texts);
    std::mt19937 random(5);
    int refused = 0;
    for (int repeat = 0; repeat < 300; ++repeat) {
        std::string bytes = whole;
        if (repeat % 3 == 0)
            bytes.resize(random() % bytes.size());
        for (int k = 0; k < 5 && !bytes.empty(); ++k)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        refused += message_of(bytes).empty() ? 0 : 1;
    }
    EXPECT_GE(refused, 100);
}

} // namespace
} // namespace searle::rheometry
