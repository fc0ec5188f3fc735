#include "app/field_files.hpp"
#include "rheometry/fields/vtu_text.hpp"
#include "tests/app/running.hpp"

#include <cstdlib>

namespace {

using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string slurry = std::string(SEARLE_SOURCE_DIR) + "/cases/din-bob-slurry.toml";
const std::string gap = std::string(SEARLE_SOURCE_DIR) + "/cases/single-gap-water.toml";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(FieldFiles, fields_of_a_din_bob_are_written_drawn_and_drawn_again) {
    const TemporaryFolder folder;
    const Outcome outcome =
        searle({"run", slurry, "-o", "out", "--set", "output.fields=true", "--set",
                "output.field_rows=2", "--set", "solver.accuracy=0.01"},
               folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(names_in(folder / "out"),
              "case.toml end_factor.csv fields report.html rheogram.csv summary.json");
    EXPECT_EQ(names_in(folder / "out/fields"), "row-0010.vtu row-0020.vtu rows.pvd");
    const auto section =
        searle::rheometry::fields::read_vtu_text(text_of(folder / "out/fields/row-0020.vtu"));
    EXPECT_EQ(section.row, 20U);
    EXPECT_EQ(section.yield_stress, 5.0);
    for (const char* name : {"velocity", "angular_velocity", "shear_rate", "shear_stress",
                             "swirl_stress", "viscosity", "yielded"}) {
        EXPECT_NE(section.find(name), nullptr) << name;
    }
    const std::string page = text_of(folder / "out/report.html");
    EXPECT_TRUE(holds(page, "Flow in the section"));
    EXPECT_TRUE(holds(page, "yield surface"));
    ASSERT_EQ(searle({"report", "out"}, folder.path()).exit_code, 0);
    EXPECT_TRUE(text_of(folder / "out/report.html") == page);
    // The fields are part of the result: --force may replace them.
    EXPECT_EQ(searle({"run", gap, "-o", "out", "--force"}, folder.path()).exit_code, 0);
    EXPECT_EQ(names_in(folder / "out"), "case.toml report.html rheogram.csv summary.json");
}

TEST(FieldFiles, a_damaged_field_file_is_named_by_report) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        searle({"run", gap, "-o", "out", "--set", "output.fields=true"}, folder.path()).exit_code,
        0);
    write_text(folder / "out/fields/row-0040.vtu", "not a field");
    const Outcome outcome = searle({"report", "out"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "row-0040.vtu")) << outcome.err;
}

TEST(FieldFiles, field_rows_without_fields_is_a_contradiction) {
    const TemporaryFolder folder;
    const Outcome outcome = searle({"check", gap, "--set", "output.field_rows=3"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "no fields are written")) << outcome.err;
}

/// meshio reads the files independently: 5 rows, and at the bob's radius the drive's speed.
TEST(FieldFiles, meshio_reads_a_run) {
    if (std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "python3-meshio is not installed";
    }
    const TemporaryFolder folder;
    ASSERT_EQ(
        searle({"run", gap, "-o", "out", "--set", "output.fields=true"}, folder.path()).exit_code,
        0);
    write_text(folder / "read.py", R"(
import csv, glob, meshio, sys
rows = list(csv.DictReader(open("out/rheogram.csv")))
files = sorted(glob.glob("out/fields/*.vtu"))
assert len(files) == 5
for file in files:
    mesh = meshio.read(file)
    row = rows[int(file[-8:-4]) - 1]
    r = mesh.points[:, 0]
    turn = mesh.point_data["angular_velocity"].ravel()
    speed = float(row["angular_velocity_rad_s"])
    assert abs(turn[r == r.min()] / speed - 1).max() < 1e-3, (file, turn[r == r.min()], speed)
    assert abs(turn[r == r.max()]).max() < 1e-9
    assert (abs(mesh.point_data["velocity"][:, 1] - r * turn) < 1e-12).all()
)");
    EXPECT_EQ(
        std::system(("cd " + folder.path().string() + " && /usr/bin/python3 read.py").c_str()), 0);
}

} // namespace
