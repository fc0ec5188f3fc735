#include "app/checkpoint_file.hpp"
#include "rheometry/rheogram_csv.hpp"
#include "tests/app/running.hpp"

#include <cmath>
#include <cstring>
#include <fstream>

// Suspensions from the command line.

namespace {

using searle::app::read_checkpoint;
using searle::app::write_checkpoint;
using searle::app::testing::names_in;
using searle::app::testing::Outcome;
using searle::app::testing::run;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

const std::string small_case = R"(title = "A few spheres"
[geometry]
type = "box"
gap = "15 um"
length = "15 um"
width = "15 um"
[fluid]
model = "newtonian"
viscosity = "1.0016 mPa.s"
density = "998.2 kg/m^3"
[protocol]
type = "steps"
shear_rates = ["100 1/s", "200 1/s"]
hold_strain = 0.5
[solver]
accuracy = "1 %"
[particles]
diameter = "1.5 um"
density = "5700 kg/m^3"
volume_fraction = 0.1
contact = { stiffness = "1e-2 N/m" }
hydrodynamics = "stresslet"
)";

TEST(SuspensionRun, gives_the_parts_of_the_stress_and_repeats_byte_for_byte) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case);
    const Outcome one = searle({"run", "case.toml", "-o", "one"}, folder.path());
    ASSERT_EQ(one.exit_code, 0) << one.err;
    const Outcome two = searle({"run", "one/case.toml", "-o", "two"}, folder.path());
    ASSERT_EQ(two.exit_code, 0) << two.err;
    EXPECT_EQ(text_of(folder / "one/rheogram.csv"), text_of(folder / "two/rheogram.csv"));
    const std::string csv = text_of(folder / "one/rheogram.csv");
    EXPECT_TRUE(csv.starts_with("time_s,wall_speed_m_s,wall_force_N,shear_rate_1_s,shear_stress_Pa,"
                                "viscosity_Pa_s,stress_error_Pa,regime,"));
    EXPECT_NE(csv.find(",fluid_stress_Pa,hydrodynamic_stress_Pa,contact_stress_Pa,dlvo_stress_Pa,"
                       "brownian_stress_Pa,statistical_error_Pa,"),
              std::string::npos);
    const auto rheogram =
        searle::rheometry::read_rheogram_csv(folder / "one/rheogram.csv").rheogram;
    ASSERT_EQ(rheogram.points.size(), 2U);
    for (const auto& point : rheogram.points) {
        ASSERT_TRUE(point.suspension.has_value());
        EXPECT_NEAR(point.suspension->total() / point.shear_stress, 1.0, 1e-12);
        // 2.5 phi and some contact; never below the fluid's own stress.
        EXPECT_GT(point.viscosity, 1.15 * 1.0016e-3);
        EXPECT_LT(point.viscosity, 2.0 * 1.0016e-3);
        EXPECT_GT(point.suspension->statistical_error, 0.0);
    }
}

TEST(SuspensionRun, an_interrupt_in_the_first_minute_loses_nothing_and_doubles_no_frame) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case);
    const auto words = [](const std::string& out) {
        return std::vector<std::string>{"run",   "case.toml",
                                        "-o",    out,
                                        "--set", "protocol.hold_strain=6",
                                        "--set", "output.trajectory_strain=1",
                                        "--set", "output.fields=true",
                                        "--set", "protocol.shear_rates=[\"100 1/s\"]"};
    };
    // The first line of progress comes after a second; the run takes several.
    const Outcome stopped = run({.arguments = words("out"),
                                 .directory = folder.path(),
                                 .signal = SIGINT,
                                 .signal_when = "particles at"});
    ASSERT_EQ(stopped.exit_code, 130) << stopped.err;
    EXPECT_NE(stopped.err.find("the same command goes on from out.checkpoint.h5"),
              std::string::npos)
        << stopped.err;
    EXPECT_EQ(names_in(folder.path()), "case.toml out.checkpoint.h5 out.trajectory");
    const Outcome on = searle(words("out"), folder.path());
    ASSERT_EQ(on.exit_code, 0) << on.err;
    EXPECT_NE(on.err.find("goes on from"), std::string::npos) << on.err;
    const Outcome whole = searle(words("whole"), folder.path());
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_EQ(names_in(folder.path()), "case.toml out out.trajectory whole whole.trajectory");
    EXPECT_EQ(text_of(folder / "out/rheogram.csv"), text_of(folder / "whole/rheogram.csv"));
    // A frame at the start and one past each unit of strain.
    const std::string frames = "frame-000000.vtp frame-000001.vtp frame-000002.vtp "
                               "frame-000003.vtp frame-000004.vtp frame-000005.vtp "
                               "frame-000006.vtp trajectory.pvd";
    EXPECT_EQ(names_in(folder / "out.trajectory"), frames);
    EXPECT_EQ(names_in(folder / "whole.trajectory"), frames);
    for (const char* name :
         {"frame-000000.vtp", "frame-000003.vtp", "frame-000006.vtp", "trajectory.pvd"})
        EXPECT_EQ(text_of(folder / "out.trajectory" / name),
                  text_of(folder / "whole.trajectory" / name))
            << name;
    for (const char* name : {"row-0001-pairs.csv", "row-0001-profile.csv", "row-0001-contacts.csv",
                             "row-0001-local-fractions.csv"}) {
        EXPECT_FALSE(text_of(folder / "out/fields" / name).empty()) << name;
        EXPECT_EQ(text_of(folder / "out/fields" / name), text_of(folder / "whole/fields" / name))
            << name;
    }
    // Another run beside an earlier trajectory asks first.
    std::filesystem::remove_all(folder / "whole");
    const Outcome beside = searle(words("whole"), folder.path());
    EXPECT_EQ(beside.exit_code, 2) << beside.err;
    EXPECT_NE(beside.err.find("--force replaces it"), std::string::npos) << beside.err;
}

TEST(SuspensionRun, figure_5_says_where_its_curves_differ_and_what_drag_alone_misses) {
    // The case itself in a box of a fortieth, with a ramp of a tenth.
    const TemporaryFolder folder;
    const std::string source =
        (std::filesystem::path(SEARLE_SOURCE_DIR) / "cases/suspension-zirconia.toml").string();
    const Outcome outcome =
        searle({"run", source, "-o", "out", "--set", "geometry.gap=\"15 um\"", "--set",
                "geometry.length=\"15 um\"", "--set", "geometry.width=\"15 um\"", "--set",
                "protocol.duration=\"10 ms\""},
               folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string summary = text_of(folder / "out/summary.json");
    for (const char* words :
         {"Stress at 180", "Where the runs differ at 180", "plain against water",
          "dlvo against plain", "stresslet against dlvo", "How the curves steepen",
          "viscosity from 90", "Drag alone carries no stress of rigid spheres", "+11.70"}) {
        EXPECT_NE(summary.find(words), std::string::npos) << words;
    }
    EXPECT_NE(text_of(folder / "out/report.html").find("Stress of the particles"),
              std::string::npos);
}

TEST(SuspensionRun, a_trajectory_without_particles_is_refused) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case.substr(0, small_case.find("[particles]")) +
                                         "[output]\ntrajectory_strain = 1\n");
    const Outcome outcome = searle({"check", "case.toml", "--set",
                                    "protocol={type=\"steps\", "
                                    "shear_rates=[\"1 1/s\"]}"},
                                   folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("no particles to follow"), std::string::npos) << outcome.err;
}

TEST(SuspensionRun, a_box_without_walls_speaks_of_none) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case);
    const Outcome outcome = searle({"run", "case.toml", "-o", "out", "--set",
                                    "particles.boundary=\"lees-edwards\"", "--set",
                                    "protocol={type=\"ramp\", from=\"0 1/s\", to=\"100 1/s\", "
                                    "duration=\"20 ms\", points=4}"},
                                   folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string page = text_of(folder / "out/report.html");
    for (const char* words : {"moving wall", "fixed wall", "wall speed over gap", "|M_bob"})
        EXPECT_EQ(page.find(words), std::string::npos) << words;
    EXPECT_EQ(page.find("It comes from the inertia"), std::string::npos);
    EXPECT_NE(page.find("It comes from the stress of the particles."), std::string::npos);
    EXPECT_NE(page.find("There are no walls"), std::string::npos);
}

TEST(SuspensionRun, refuses_what_does_not_fit) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case);
    const auto with = [&](const std::string& setting) {
        return searle({"run", "case.toml", "-o", "out", "--set", setting}, folder.path());
    };
    const auto expect = [&](const std::string& setting, int code, const std::string& words) {
        const Outcome outcome = with(setting);
        EXPECT_EQ(outcome.exit_code, code) << setting << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "out")) << setting;
    };
    expect("particles.time_step=\"0.1 ms\"", 2, "make contacts and drag swing up");
    expect("particles.time_step=\"1 s\"", 2, "strained by");
    expect("particles.volume_fraction=0.7", 2, "0.64");
    expect("particles.diameter=\"20 um\"", 2, "does not fit");
    expect("particles.diameter=\"6.8 um\"", 2, "two images");
    expect("geometry.gap=\"1 m\"", 2, "more than the");
    // Spheres without stiffness to speak of are pressed through each other.
    expect("particles.contact.stiffness=\"1e-8 N/m\"", 3, "overlap");
    expect("fluid={model=\"power-law\", consistency=\"1 Pa.s^n\", flow_index=0.5, "
           "density=\"998 kg/m^3\"}",
           4, "Newtonian");
}

TEST(CheckpointFile, comes_back_bit_for_bit_and_is_refused_to_others) {
    const TemporaryFolder folder;
    const auto file = folder / "run.checkpoint.h5";
    EXPECT_FALSE(read_checkpoint(file, "a").has_value());
    searle::solvers::suspension::Checkpoint checkpoint;
    const std::vector<double> values{1.0 / 3.0, -0.0, 5e-324, std::nan(""), 1e300};
    checkpoint.put("values", values);
    checkpoint.put("none", std::vector<double>{});
    write_checkpoint(file, checkpoint, "a");
    const auto back = read_checkpoint(file, "a");
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(back->column("values").size(), values.size());
    EXPECT_EQ(
        std::memcmp(back->column("values").data(), values.data(), values.size() * sizeof(double)),
        0);
    EXPECT_TRUE(back->column("none").empty());
    EXPECT_THROW(static_cast<void>(read_checkpoint(file, "b")), searle::app::CheckpointError);
    std::ofstream(file, std::ios::binary) << "no HDF5";
    EXPECT_THROW(static_cast<void>(read_checkpoint(file, "a")), searle::app::CheckpointError);
    EXPECT_EQ(searle::app::testing::names_in(folder.path()), "run.checkpoint.h5");
}

TEST(CheckpointFile, a_changed_value_or_name_is_noticed) {
    const TemporaryFolder folder;
    const auto file = folder / "run.checkpoint.h5";
    searle::solvers::suspension::Checkpoint checkpoint;
    checkpoint.put("values", std::vector<double>{1.25, 2.5});
    write_checkpoint(file, checkpoint, "a");
    const std::string whole = text_of(file);
    const double value = 2.5;
    const std::string in_file(reinterpret_cast<const char*>(&value), sizeof value);
    for (const std::string& part : {in_file, std::string("values"), std::string("checksum")}) {
        std::string damaged = whole;
        const std::size_t at = damaged.find(part);
        ASSERT_NE(at, std::string::npos);
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        std::ofstream(file, std::ios::binary) << damaged;
        EXPECT_THROW(static_cast<void>(read_checkpoint(file, "a")), searle::app::CheckpointError);
    }
    std::ofstream(file, std::ios::binary) << whole;
    EXPECT_TRUE(read_checkpoint(file, "a").has_value());
}

TEST(CheckpointFile, of_another_case_stops_the_run_with_a_message) {
    const TemporaryFolder folder;
    write_text(folder / "case.toml", small_case);
    write_checkpoint(folder / "out.checkpoint.h5", {}, "another");
    const Outcome refused = searle({"run", "case.toml", "-o", "out"}, folder.path());
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_NE(refused.err.find("another case or version"), std::string::npos) << refused.err;
    const Outcome anew = searle({"run", "case.toml", "-o", "out", "--force"}, folder.path());
    EXPECT_EQ(anew.exit_code, 0) << anew.err;
}

} // namespace
