#include "rheometry/tables/flow_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace rheometry = searle::rheometry;

class FlowCurves : public testing::Test {
protected:
    std::filesystem::path write(const std::string& text) {
        file_ =
            std::filesystem::temp_directory_path() /
            ("searle_" +
             std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
        std::ofstream(file_, std::ios::binary) << text;
        return file_;
    }
    void TearDown() override { std::filesystem::remove(file_); }

private:
    std::filesystem::path file_;
};

TEST_F(FlowCurves, decimal_commas_and_a_line_of_units_are_read_in_si) {
    const auto read = rheometry::read_flow_curves(
        write("Shear Rate;Shear Stress\n[1/s];[mPa]\n1,5;5000,1\n10;9000\n"));
    ASSERT_EQ(read.curves.size(), 1U);
    EXPECT_EQ(read.curves[0].points[0].rate, 1.5);
    EXPECT_NEAR(read.curves[0].points[0].stress, 5.0001, 1e-12);
    EXPECT_EQ(read.curves[0].points[0].line, 3U);
}

// The layout of RheoCompass: a preamble, a first column that only the headings have, an empty line,
// units of columns that are not needed, tabs and decimal commas (here as UTF-8).
TEST_F(FlowCurves, tables_below_a_preamble_are_found_and_named) {
    const std::string table = "Interval data:\tPoint No.\tShear Rate\tShear Stress\tViscosity\r\n"
                              "\t\t\t\t\r\n\t\t[1/s]\t[Pa]\t[mPa·s]\r\n"
                              "\t1\t1,0\t5,1\t5100\r\n\t2\t3,0\t6,2\t2067\r\n\r\n";
    const auto read = rheometry::read_flow_curves(write(
        "Project:\tX\r\nTest:\tFlow\r\n\r\nResult:\tUp\r\n" + table + "Result:\tDown\r\n" + table));
    ASSERT_EQ(read.curves.size(), 2U);
    EXPECT_EQ(read.curves[0].name, "Up");
    EXPECT_EQ(read.curves[1].name, "Down");
    ASSERT_EQ(read.curves[1].points.size(), 2U);
    EXPECT_EQ(read.curves[1].points[1].stress, 6.2);
    EXPECT_EQ(read.curves[0].points[0].line, 8U);
}

TEST_F(FlowCurves, blocks_are_curves_of_their_own) {
    const auto read = rheometry::read_flow_curves(
        write("7\tmud A\t1\n100\t16,6\n10\t7,02\n\n8\tmud B\t1\n100\t13,3\n"));
    ASSERT_EQ(read.curves.size(), 2U);
    EXPECT_EQ(read.curves[0].name, "7 mud A");
    EXPECT_EQ(read.curves[0].points[1].stress, 7.02);
    EXPECT_EQ(read.curves[1].points.size(), 1U);
}

TEST_F(FlowCurves, text_in_place_of_a_number_names_line_and_column) {
    try {
        (void)rheometry::read_flow_curves(
            write("shear_rate_1_s,shear_stress_Pa\n1,5\n2,nan\n4,x7\n"));
        FAIL() << "x7 was read as a number";
    } catch (const rheometry::TableError& error) {
        ASSERT_EQ(error.faults().size(), 1U);
        EXPECT_EQ(error.faults()[0].line, 4U);
        EXPECT_EQ(error.faults()[0].column, "shear_stress_Pa");
    }
}

TEST_F(FlowCurves, fault_in_a_block_names_its_line) {
    try {
        (void)rheometry::read_flow_curves(write("7\tmud\t1\n100\t16,6\n10\tabc\n"));
        FAIL() << "abc was read as a number";
    } catch (const rheometry::TableError& error) {
        EXPECT_EQ(error.faults()[0].line, 3U);
    }
}

TEST_F(FlowCurves, wrong_unit_is_an_error_that_names_the_column) {
    EXPECT_THROW(
        (void)rheometry::read_flow_curves(write("Shear Rate [rpm],Shear Stress [Pa]\n1,2\n3,4\n")),
        rheometry::TableError);
}

} // namespace
