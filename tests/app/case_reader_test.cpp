#include "app/case_reader.hpp"

#include "tests/app/case_texts.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

using namespace searle;
using namespace searle::app;

namespace {

class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& content)
        : path_{std::filesystem::temp_directory_path() /
                ("searle_case_" + std::to_string(::getpid()) + ".toml")} {
        std::ofstream{path_, std::ios::binary} << content;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string message_of(const std::filesystem::path& file) {
    try {
        static_cast<void>(read_case(file));
    } catch (const CaseError& error) {
        EXPECT_EQ(error.faults().size(), 1U);
        return error.what();
    }
    return "";
}

} // namespace

TEST(case_reader, fills_the_scene_in_si_units) {
    const Case one = read_text(with("to = \"100 1/s\"", "from = \"-2 rpm\"\nto = \"100 1/s\""));
    const auto& gap = std::get<geometry::ConcentricCylinders>(one.scene.instrument);
    EXPECT_EQ(gap.bob_radius, 0.014);
    EXPECT_EQ(gap.cup_radius, 0.015);
    EXPECT_EQ(gap.height, 0.042);
    EXPECT_EQ(std::get<laws::flow::Newtonian>(one.scene.fluid.law).viscosity, 0.0010016);
    EXPECT_EQ(one.scene.fluid.density, 998.2);
    const auto& ramp = std::get<rheometry::Ramp>(one.scene.protocol.program);
    EXPECT_EQ(ramp.from.kind, rheometry::SpeedKind::drive);
    EXPECT_NEAR(ramp.from.value, -2.0 * 2.0 * std::numbers::pi / 60.0, 1e-15);
    EXPECT_EQ(ramp.to.kind, rheometry::SpeedKind::shear_rate);
    EXPECT_EQ(ramp.to.value, 100.0);
    EXPECT_EQ(ramp.duration, 35.0);
    EXPECT_EQ(ramp.points, 100);
    EXPECT_EQ(one.scene.protocol.start, rheometry::StartState::steady);
    EXPECT_EQ(one.name, "case");
    EXPECT_FALSE(one.scene.particles.has_value());
}

// Defaults: the contract.
TEST(case_reader, defaults_are_those_of_the_contract) {
    const Case one = read_text(std::string{valid_case});
    EXPECT_EQ(one.scene.solver.engine, solvers::Engine::native);
    EXPECT_EQ(one.scene.solver.model, solvers::Model::automatic);
    EXPECT_EQ(one.scene.solver.accuracy, 1e-3);
    EXPECT_EQ(one.scene.solver.secondary_flow, solvers::Switch::automatic);
    EXPECT_EQ(one.scene.conversion.definition, rheometry::RateDefinition::bob_wall);
    EXPECT_EQ(one.scene.conversion.end_factor, 1.0);
    EXPECT_FALSE(one.scene.output.fields);
    EXPECT_EQ(one.scene.mesh.cells_across_gap, std::nullopt);

    const std::string din = with(
        "type = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\nheight = \"42 mm\"",
        "type = \"din-bob\"\nbob_radius = \"14 mm\"\nradius_ratio = 1.0847");
    const Case bob_case = read_text(din);
    const auto& bob = std::get<geometry::DinBob>(bob_case.scene.instrument);
    EXPECT_EQ(bob.cup_radius, 0.014 * 1.0847);
    EXPECT_EQ(bob.length_ratio, 3.0);
    EXPECT_EQ(bob.bottom_ratio, 1.0);
    EXPECT_EQ(bob.top_ratio, 1.0);
    EXPECT_EQ(bob.shaft_ratio, 0.3);
    EXPECT_NEAR(bob.cone_angle, 2.0 * std::numbers::pi / 3.0, 1e-15);
    EXPECT_EQ(bob_case.scene.conversion.definition, rheometry::RateDefinition::iso_3219);
    EXPECT_EQ(bob_case.scene.conversion.end_factor, 1.1);
}

TEST(case_reader, accuracy_takes_a_number_or_percent) {
    EXPECT_EQ(read_text(also("[solver]\naccuracy = \"0.1 %\"\n")).scene.solver.accuracy, 1e-3);
    EXPECT_EQ(read_text(also("[solver]\naccuracy = 1e-10\n")).scene.solver.accuracy, 1e-10);
    EXPECT_EQ(only_fault(also("[solver]\naccuracy = 9e-11\n")).key, "solver.accuracy");
    EXPECT_EQ(only_fault(also("[solver]\naccuracy = 1\n")).key, "solver.accuracy");
    EXPECT_EQ(only_fault(also("[solver]\naccuracy = \"100 %\"\n")).key, "solver.accuracy");
    EXPECT_EQ(only_fault(also("[solver]\naccuracy = nan\n")).key, "solver.accuracy");
}

TEST(case_reader, switches_take_words_and_booleans) {
    const auto read = [](const char* value) {
        return read_text(also("[solver]\nsecondary_flow = " + std::string{value} + "\n"))
            .scene.solver.secondary_flow;
    };
    EXPECT_EQ(read("\"auto\""), solvers::Switch::automatic);
    EXPECT_EQ(read("true"), solvers::Switch::on);
    EXPECT_EQ(read("false"), solvers::Switch::off);
    EXPECT_EQ(only_fault(also("[solver]\nsecondary_flow = \"true\"\n")).key,
              "solver.secondary_flow");
}

TEST(case_reader, steps_take_a_list_or_a_range) {
    const auto steps = [](const std::string& lines) {
        const std::string text =
            with("type = \"ramp\"\nto = \"100 1/s\"\nduration = \"35 s\"\npoints = 100", lines);
        return std::get<rheometry::Steps>(read_text(text).scene.protocol.program);
    };
    const auto listed = steps("type = \"steps\"\nshear_rates = [\"1 1/s\", \"-10 1/s\"]");
    ASSERT_EQ(listed.speeds.size(), 2U);
    EXPECT_EQ(listed.speeds[1].value, -10.0);
    EXPECT_EQ(listed.hold, std::nullopt);

    const auto log = steps("type = \"steps\"\nhold = \"10 s\"\nshear_rates = { from = \"1 1/s\", "
                           "to = \"1000 1/s\", count = 4, spacing = \"log\" }");
    ASSERT_EQ(log.speeds.size(), 4U);
    EXPECT_EQ(log.speeds.front().value, 1.0);
    EXPECT_NEAR(log.speeds[1].value, 10.0, 1e-13);
    EXPECT_NEAR(log.speeds[2].value, 100.0, 1e-12);
    EXPECT_EQ(log.speeds.back().value, 1000.0);
    EXPECT_EQ(log.hold, 10.0);

    const auto linear =
        steps("type = \"steps\"\nangular_velocities = { from = \"0 rad/s\", "
              "to = \"3 rad/s\", count = 4, spacing = \"linear\" }\nhold = \"1 s\"");
    ASSERT_EQ(linear.speeds.size(), 4U);
    EXPECT_EQ(linear.speeds[0].value, 0.0);
    EXPECT_EQ(linear.speeds[1].value, 1.0);
    EXPECT_EQ(linear.speeds[3].value, 3.0);
    EXPECT_EQ(linear.speeds[3].kind, rheometry::SpeedKind::drive);
}

TEST(case_reader, segments_may_turn_back) {
    const std::string text =
        with("type = \"ramp\"\nto = \"100 1/s\"\nduration = \"35 s\"\npoints = 100",
             "type = \"segments\"\n[[protocol.segments]]\nto = \"100 1/s\"\nduration = \"35 "
             "s\"\npoints = 5\n"
             "[[protocol.segments]]\nto = \"-5 rad/s\"\nduration = \"1 min\"");
    const auto segments = std::get<rheometry::Segments>(read_text(text).scene.protocol.program);
    ASSERT_EQ(segments.segments.size(), 2U);
    EXPECT_EQ(segments.segments[0].points, 5);
    EXPECT_EQ(segments.segments[1].to.value, -5.0);
    EXPECT_EQ(segments.segments[1].to.kind, rheometry::SpeedKind::drive);
    EXPECT_EQ(segments.segments[1].duration, 60.0);
    EXPECT_EQ(segments.segments[1].points, 50);
}

TEST(case_reader, constant_speed_is_a_ramp_too) {
    const Case one =
        read_text(with("to = \"100 1/s\"", "from = \"5 1/s\"\nto = \"5 1/s\"\nstart = \"rest\""));
    EXPECT_EQ(one.scene.protocol.start, rheometry::StartState::rest);
}

TEST(case_reader, remembers_lines_and_texts) {
    const Case one = read_text(std::string{valid_case}, {"geometry.cup_radius=16 mm"});
    EXPECT_EQ(one.lines.at("geometry.bob_radius"), 3);
    EXPECT_EQ(one.lines.at("protocol.to"), 14);
    EXPECT_EQ(one.written.at("geometry.bob_radius"), "14 mm");
    EXPECT_FALSE(one.lines.contains("geometry.cup_radius")) << "given by --set";
    EXPECT_EQ(one.written.at("geometry.cup_radius"), "16 mm");
    EXPECT_FALSE(one.lines.contains("solver.accuracy")) << "a default";
}

TEST(case_reader, overrides_replace_add_and_reach_into_lists) {
    const Case one = read_text(
        std::string{valid_case},
        {"geometry.cup_radius=16mm", "solver.accuracy=0.5 %", "protocol.points = 7",
         "fluid={model = \"bingham\", yield_stress = \"1 Pa\", plastic_viscosity = \"1 cP\", "
         "density = \"1 g/cm^3\"}",
         "title=Water"});
    EXPECT_EQ(std::get<geometry::ConcentricCylinders>(one.scene.instrument).cup_radius, 0.016);
    EXPECT_EQ(one.scene.solver.accuracy, 5e-3);
    EXPECT_EQ(std::get<rheometry::Ramp>(one.scene.protocol.program).points, 7);
    EXPECT_EQ(std::get<laws::flow::Bingham>(one.scene.fluid.law).yield_stress, 1.0);
    EXPECT_EQ(one.scene.title, "Water");

    const std::string segments =
        with("type = \"ramp\"\nto = \"100 1/s\"\nduration = \"35 s\"\npoints = 100",
             "type = \"segments\"\nsegments = [{to = \"1 1/s\", duration = \"1 s\"}]");
    const Case changed = read_text(segments, {"protocol.segments.1.to=9 1/s"});
    EXPECT_EQ(std::get<rheometry::Segments>(changed.scene.protocol.program).segments[0].to.value,
              9.0);
    EXPECT_EQ(only_fault(segments, {"protocol.segments.2.to=9 1/s"}).allowed,
              "a number from 1 to 1");
}

TEST(case_reader, hash_tells_cases_apart) {
    const Case one = read_text(std::string{valid_case});
    EXPECT_EQ(one.hash.size(), 16U);
    EXPECT_EQ(one.hash, read_text("# a comment\n" + std::string{valid_case}).hash);
    EXPECT_NE(one.hash, read_text(with("15 mm", "15.1 mm")).hash);
}

TEST(case_reader, particles_are_read_and_flagged) {
    const Case one = read_text(also(R"(
[particles]
diameters = [{ diameter = "1 um", share = 0.5 }, { diameter = "2 um", share = "50 %" }]
density = "5700 kg/m^3"
volume_fraction = 0.0468
contact = { model = "hooke", stiffness = "1e-2 N/m", restitution = 0.9, friction = 0.3 }
dlvo = { double_layer = "weak-overlap", hamaker = "6e-20 J", zeta_potential = "32 mV", debye_length = "10 nm", relative_permittivity = 80.1, minimum_separation = "0.3 nm", cutoff = "100 nm" }
temperature = "20 degC"
gravity = true
[coupling]
cells = [8, 8, 8]
model = "A"
interval = "auto"
)"));
    EXPECT_TRUE(one.scene.particles.has_value());
    EXPECT_NE(one.resolved_toml.find("temperature = \"293.15 K\""), std::string::npos);
    EXPECT_NE(one.resolved_toml.find("gravity = \"9.80665 m/s^2\""), std::string::npos);
    EXPECT_NE(one.resolved_toml.find("hamaker = \"6e-20 J\""), std::string::npos);
}

TEST(case_reader, files_that_are_no_case_get_one_clear_message) {
    EXPECT_NE(message_of("/there/is/no/such.toml").find("no such file"), std::string::npos);
    EXPECT_NE(message_of(std::filesystem::temp_directory_path()).find("is a directory"),
              std::string::npos);
    EXPECT_NE(message_of(TemporaryFile{""}.path()).find("is empty"), std::string::npos);
    EXPECT_NE(message_of(TemporaryFile{" \n\t\n"}.path()).find("is empty"), std::string::npos);
    EXPECT_NE(message_of(TemporaryFile{std::string("a = 1\0b", 7)}.path()).find("binary"),
              std::string::npos);
    EXPECT_NE(message_of("/dev/null").find("not a regular file"), std::string::npos);
}

TEST(case_reader, large_file_is_refused_unread) {
    const TemporaryFile file{"x"};
    std::filesystem::resize_file(file.path(), 100U << 20U); // sparse: 100 MB without the disk
    EXPECT_NE(message_of(file.path()).find("is 104.9 MB large"), std::string::npos);
}

TEST(case_reader, file_with_a_sweep_is_no_single_case) {
    const TemporaryFile file{also("[sweep]\nvary = { \"protocol.points\" = [10, 20] }\n")};
    const std::string message = message_of(file.path());
    EXPECT_NE(message.find("2 cases"), std::string::npos) << message;
    EXPECT_NE(message.find("points=10"), std::string::npos) << message;
    EXPECT_EQ(read_cases(file.path()).size(), 2U);
}
