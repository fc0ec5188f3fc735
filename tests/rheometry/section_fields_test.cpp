#include "rheometry/fields/base64.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/fields/vtu_text.hpp"
#include "rheometry/report/contours.hpp"
#include "rheometry/report/section_picture.hpp"

#include "markup_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

namespace searle::rheometry {
namespace {

namespace fs = std::filesystem;
using fields::SectionFields;

/// Two patches side by side, 1 <= r <= 3 and 0 <= z <= 2, with value(r, z).
template <class Value>
SectionFields two_patches(std::size_t columns, const Value& value) {
    SectionFields section;
    const auto steps = static_cast<double>(columns - 1);
    for (const double left : {1.0, 2.0}) {
        const std::uint32_t first =
            fields::add_patch(section, columns, columns, [&](std::size_t column, std::size_t row) {
                return fields::SectionPoint{left + static_cast<double>(column) / steps,
                                            2.0 * static_cast<double>(row) / steps};
            });
        const auto last = static_cast<std::uint32_t>(columns - 1);
        section.outline.push_back({fields::OutlineKind::fixed_wall, {first, first + last}});
    }
    fields::NodalField field{.name = "shear_rate", .unit = "1/s", .components = 1, .values = {}};
    for (const auto& point : section.points) {
        field.values.push_back(value(point.r, point.z));
    }
    section.fields.push_back(std::move(field));
    return section;
}

double loop_area(const report::Polyline& loop) {
    double twice = 0.0;
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
        twice += loop[k].r * loop[k + 1].z - loop[k + 1].r * loop[k].z;
    }
    return 0.5 * twice;
}

/// Test vectors of RFC 4648, section 10.
TEST(Base64, known_texts_and_back) {
    EXPECT_EQ(fields::base64(""), "");
    EXPECT_EQ(fields::base64("f"), "Zg==");
    EXPECT_EQ(fields::base64("fo"), "Zm8=");
    EXPECT_EQ(fields::base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(fields::from_base64("Zm9v\nYmE="), "fooba");
    EXPECT_THROW(static_cast<void>(fields::from_base64("Zm9*")), std::runtime_error);
}

TEST(SectionFields, rows_are_spread_evenly_and_the_last_is_there) {
    EXPECT_EQ(fields::spread_rows(100, 5), (std::vector<std::size_t>{20, 40, 60, 80, 100}));
    EXPECT_EQ(fields::spread_rows(3, 5), (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(fields::spread_rows(7, 2), (std::vector<std::size_t>{4, 7}));
    EXPECT_TRUE(fields::spread_rows(0, 5).empty());
}

TEST(VtuText, comes_back_bit_for_bit) {
    SectionFields section = two_patches(4, [](double r, double z) { return r / 3.0 + z * z; });
    section.row = 17;
    section.time = 0.1;
    section.speed = -1.0 / 3.0;
    section.yield_stress = 5.0;
    section.fields.push_back({.name = "velocity", .unit = "m/s", .components = 3, .values = {}});
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        section.fields.back().values.insert(section.fields.back().values.end(),
                                            {0.1 * static_cast<double>(k), 0.0, -1e-300});
    }
    section.fields.front().values[3] = std::numeric_limits<double>::quiet_NaN();
    const SectionFields back = fields::read_vtu_text(fields::vtu_text(section));
    EXPECT_EQ(fields::vtu_text(back), fields::vtu_text(section));
    EXPECT_EQ(back.row, 17U);
    EXPECT_EQ(back.speed, section.speed);
    EXPECT_EQ(back.cells, section.cells);
    ASSERT_EQ(back.fields.size(), 2U);
    EXPECT_EQ(back.fields[1].values, section.fields[1].values);
    EXPECT_EQ(back.fields[1].unit, "m/s");
    EXPECT_TRUE(std::isnan(back.fields[0].values[3]));
    EXPECT_EQ(back.outline.size(), 2U);
}

TEST(VtuText, damaged_files_are_refused) {
    const std::string good = fields::vtu_text(two_patches(3, [](double, double) { return 1.0; }));
    EXPECT_THROW(static_cast<void>(fields::read_vtu_text("")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(fields::read_vtu_text(good.substr(0, good.size() / 2))),
                 std::runtime_error);
    std::string short_array = good;
    short_array.replace(short_array.find("NumberOfPoints=\"18\""), 19, "NumberOfPoints=\"17\"");
    EXPECT_THROW(static_cast<void>(fields::read_vtu_text(short_array)), std::runtime_error);
}

/// meshio is an independent reader of the format.
TEST(VtuText, meshio_reads_the_same_numbers) {
    if (std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "python3-meshio is not installed";
    }
    SectionFields section = two_patches(3, [](double r, double z) { return 10.0 * r + z; });
    section.fields.push_back({.name = "velocity", .unit = "m/s", .components = 3, .values = {}});
    for (const auto& point : section.points) {
        section.fields.back().values.insert(section.fields.back().values.end(),
                                            {0.0, point.r, 2.0 * point.z});
    }
    const fs::path folder = fs::path(::testing::TempDir()) / "searle-section-fields";
    fs::create_directories(folder);
    std::ofstream(folder / "section.vtu", std::ios::binary) << fields::vtu_text(section);
    std::ofstream(folder / "read.py") << R"(
import meshio, numpy, sys
mesh = meshio.read(sys.argv[1])
x, y, z = mesh.points.T
assert len(x) == 18 and (y == 0).all() and x.min() == 1 and x.max() == 3 and z.max() == 2
assert [(c.type, len(c.data)) for c in mesh.cells] == [("quad", 8), ("line", 2)]
assert (mesh.point_data["shear_rate"].ravel() == 10 * x + z).all()
assert (mesh.point_data["velocity"] == numpy.array([0 * x, x, 2 * z]).T).all()
assert [list(p.ravel()) for p in mesh.cell_data["part"]] == [[0] * 8, [2] * 2]
)";
    EXPECT_EQ(std::system(("/usr/bin/python3 " + (folder / "read.py").string() + " " +
                           (folder / "section.vtu").string())
                              .c_str()),
              0);
    fs::remove_all(folder);
}

/// A circle of radius 0.6 around (2, 1) lies across the seam of the patches: the region above and
/// below the level have the areas pi 0.36 and 4 - pi 0.36, up to the chords' second order.
TEST(Contours, regions_of_a_cone_have_the_area_of_a_circle_to_second_order) {
    const auto cone = [](double r, double z) { return 1.0 - std::hypot(r - 2.0, z - 1.0); };
    std::vector<double> errors;
    for (const std::size_t columns : {11U, 21U, 41U}) {
        const auto scalar = report::drawn_scalar(two_patches(columns, cone), "shear_rate");
        const auto above = report::region_above(scalar, 0.4);
        ASSERT_EQ(above.size(), 1U);
        errors.push_back(std::abs(loop_area(above.front()) - 0.36 * std::numbers::pi));
        const auto lines = report::level_lines(scalar, 0.4);
        ASSERT_EQ(lines.size(), 1U);
        for (const auto& point : lines.front()) {
            EXPECT_NEAR(std::hypot(point.r - 2.0, point.z - 1.0), 0.6, 0.5 / double(columns));
        }
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.5);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.5);
}

TEST(Contours, a_region_reaches_the_border_and_may_have_a_hole) {
    const auto bowl = [](double r, double z) { return std::hypot(r - 2.0, z - 1.0); };
    const auto scalar = report::drawn_scalar(two_patches(21, bowl), "shear_rate");
    const auto loops = report::region_above(scalar, 0.5);
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_NEAR(loop_area(loops[0]) + loop_area(loops[1]), 4.0 - 0.25 * std::numbers::pi, 5e-3);
    const auto everything = report::region_above(scalar, -1.0);
    ASSERT_EQ(everything.size(), 1U);
    EXPECT_NEAR(loop_area(everything.front()), 4.0, 1e-12);
    EXPECT_TRUE(report::region_above(scalar, 9.0).empty());
}

TEST(SectionPicture, is_well_formed_whatever_the_field) {
    const SectionFields section =
        two_patches(5, [](double r, double z) { return r > 2.5 ? 1e6 : z; });
    SectionFields awkward = section;
    awkward.fields.front().values.assign(section.points.size(),
                                         std::numeric_limits<double>::quiet_NaN());
    SectionFields zero = section;
    zero.fields.front().values.assign(section.points.size(), 0.0);
    for (const SectionFields& each : {section, awkward, zero, SectionFields{}}) {
        report::SectionPicture picture{.section = &each,
                                       .field = "shear_rate",
                                       .name = report::RichText{"rate & <1/s>"},
                                       .lines = {{"shear_rate", {0.5, 1.0}, "streamline", false}},
                                       .blank_field = "shear_rate",
                                       .blank_below = 0.2,
                                       .id = "rate",
                                       .title = "rate"};
        EXPECT_EQ(test::markup_fault(report::draw(picture)), "");
    }
}

} // namespace
} // namespace searle::rheometry
