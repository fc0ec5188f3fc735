#include "tests/app/running.hpp"

#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string cases = std::string(SEARLE_SOURCE_DIR) + "/cases/";
const std::string water = cases + "single-gap-water.toml";
const std::string bob = cases + "din-bob-water.toml";

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

class MeshVerb : public ::testing::Test {
protected:
    Outcome mesh(std::vector<std::string> words) const {
        words.insert(words.begin(), "mesh");
        return searle(words, folder.path());
    }
    /// Refused as wrong usage, with these words, and nothing left behind.
    void expect_refused(const std::vector<std::string>& words, const std::string& part) const {
        const Outcome outcome = mesh(words);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, part)) << outcome.err;
        EXPECT_EQ(names_in(folder.path()), "") << part;
    }

    TemporaryFolder folder;
};

TEST_F(MeshVerb, writes_the_mesh_and_prints_its_checks) {
    const Outcome outcome = mesh({bob, "-o", "bob.msh", "--set", "mesh.cells_across_gap=4"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(holds(outcome.out, "Mesh OK.")) << outcome.out;
    EXPECT_EQ(names_in(folder.path()), "bob.msh");
}

TEST_F(MeshVerb, needs_neither_fluid_nor_protocol) {
    write_text(folder / "only.toml", "[geometry]\ntype = \"box\"\ngap = \"1 mm\"\n"
                                     "length = \"10 mm\"\nwidth = \"10 mm\"\n");
    const Outcome outcome = mesh({"only.toml", "-o", "box.msh"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    // Every other verb does.
    EXPECT_EQ(searle({"check", "only.toml"}, folder.path()).exit_code, 2);
}

TEST_F(MeshVerb, checks_the_fluid_of_a_case_that_has_one) {
    expect_refused({water, "-o", "a.msh", "--set", "fluid.viscosity=1 m"}, "fluid.viscosity");
}

TEST_F(MeshVerb, json_holds_the_checks_as_numbers) {
    const Outcome outcome = mesh({water, "-o", "a.msh", "--json"});
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_TRUE(json.at("ok"));
    EXPECT_NEAR(json.at("patches").at("bob").at("relative_error"), 0.0, 1e-12);
    EXPECT_EQ(json.at("slice_factor"), 72.0); // 360 / 5 deg
}

TEST_F(MeshVerb, draws_preview_and_dimensions) {
    const Outcome outcome = mesh({bob, "-o", "a.msh", "--set", "mesh.cells_across_gap=4",
                                  "--preview", "p.svg", "--drawing", "d.svg", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(holds(text_of(folder / "p.svg"), "bob_cone"));
    EXPECT_TRUE(holds(text_of(folder / "d.svg"), "42\u00a0mm"));
}

TEST_F(MeshVerb, draws_an_eccentric_bob_along_its_axis) {
    const Outcome outcome = mesh({water, "-o", "a.msh", "--set", "mesh.cells_across_gap=4", "--set",
                                  "geometry.offset=0.5 mm", "--set", "solver.engine=openfoam",
                                  "--set", "mesh.extent=full", "--preview", "p.svg", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string picture = text_of(folder / "p.svg");
    EXPECT_TRUE(holds(picture, ">cup<"));
    EXPECT_FALSE(holds(picture, ">slice_bottom<"));
    EXPECT_TRUE(holds(picture, "1.1 mm wide"));
}

TEST_F(MeshVerb, refuses_bad_requests_in_one_message_and_leaves_nothing) {
    const auto set = [](const std::string& value, const std::string& file = water) {
        return std::vector<std::string>{file, "-o", "a.msh", "--set", value};
    };
    expect_refused(set("mesh.cell_size=2 mm"), "thinner than one cell");
    expect_refused(set("mesh.wedge_angle=0 deg"), "above 0 deg");
    expect_refused(set("mesh.wedge_angle=-5 deg"), "above 0 deg");
    expect_refused(set("mesh.wedge_angle=361 deg"), "at most 360 deg");
    expect_refused(set("geometry.cone_angle=0 deg", bob), "cone_angle");
    expect_refused(set("geometry.cone_angle=181 deg", bob), "at most 180 deg");
    expect_refused(set("geometry.shaft_ratio=1.2", bob), "shaft_ratio");
    expect_refused(set("geometry.top_ratio=-0.1", bob), "top_ratio");
    expect_refused(set("mesh.cell_size=1 nm"), "more than mesh.most_cells");
    expect_refused({water, "-o", "a.msh", "--set", "mesh.cells_across_gap=100000", "--set",
                    "mesh.axial_cells=1000000", "--set", "mesh.angular_cells=1000"},
                   "cells in all are more than mesh.most_cells");
    expect_refused({water, "-o", "a.mhs"}, "did you mean .msh?");
    expect_refused({water, "-o", "missing/a.msh"}, "there is no folder");
    expect_refused({water, "-o", "a.msh", "--preview", "p.gif"}, ".svg or .png");
    expect_refused({water, "-o", "a.stl", "--set", "mesh.extent=section"}, "surface of a solid");
    expect_refused({water, "-o", "a/", "--set", "mesh.order=2"}, "mesh.order = 1");
}

TEST_F(MeshVerb, a_place_that_takes_no_files_is_named_as_it_was_given) {
    for (const char* place : {"/proc/a.msh", "/proc/a.su2", "/proc/"}) {
        const Outcome outcome = mesh({water, "-o", place});
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, place)) << outcome.err;
        EXPECT_FALSE(holds(outcome.err, "part-")) << outcome.err;
    }
}

TEST_F(MeshVerb, a_full_disk_leaves_no_half_mesh) {
    for (const char* target : {"a.msh", "a.vtu", "a/", "a/b/"}) {
        const Outcome outcome = run({.arguments = {"mesh", water, "-o", target},
                                     .directory = folder.path(),
                                     .file_size_limit = 4096});
        EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, "File too large")) << outcome.err;
        EXPECT_EQ(names_in(folder.path()), "") << target;
    }
}

TEST_F(MeshVerb, a_missing_meshio_says_how_to_get_it) {
    // A module of that name which cannot be imported stands before the real one.
    const TemporaryFolder modules;
    write_text(modules / "meshio.py", "raise ImportError\n");
    const Outcome outcome = run({.arguments = {"PYTHONPATH=" + modules.path().string(),
                                               SEARLE_PROGRAM, "mesh", water, "-o", "a.su2"},
                                 .directory = folder.path(),
                                 .program = "/usr/bin/env"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "apt-get install python3-meshio")) << outcome.err;
    EXPECT_EQ(names_in(folder.path()), "");
}

TEST_F(MeshVerb, the_report_of_a_din_bob_shows_the_mesh_it_was_solved_on) {
    const std::string slurry = cases + "din-bob-slurry.toml";
    const Outcome outcome = searle({"run", slurry, "-o", "r", "--quiet"}, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string report = text_of(folder / "r/report.html");
    EXPECT_TRUE(holds(report, "<h2>Mesh</h2>"));
    for (const char* patch :
         {"bob", "bob_cone", "bob_top", "shaft", "cup", "cup_floor", "free_surface", "axis"})
        EXPECT_TRUE(holds(report, std::string(">") + patch + "</text>")) << patch;
    // The same page from the folder alone.
    ASSERT_EQ(searle({"report", "r"}, folder.path()).exit_code, 0);
    EXPECT_EQ(text_of(folder / "r/report.html"), report);
}

TEST_F(MeshVerb, the_report_of_a_radial_run_shows_none) {
    const Outcome outcome = searle({"run", water, "-o", "r", "--quiet"}, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(holds(text_of(folder / "r/report.html"), "<h2>Mesh</h2>"));
}

} // namespace
