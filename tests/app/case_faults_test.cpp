#include "tests/app/case_texts.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace searle;
using namespace searle::app;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::string ramp = "type = \"ramp\"\nto = \"100 1/s\"\nduration = \"35 s\"\npoints = 100";
const std::string single_gap =
    "type = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\nheight = \"42 mm\"";
const std::string newtonian = "model = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"";
const std::string din_bob = "type = \"din-bob\"\nbob_radius = \"14 mm\"\n";
const std::string box = "type = \"box\"\ngap = \"1 mm\"\nlength = \"88 mm\"\nwidth = \"42 mm\"";
const std::string double_gap = "type = \"double-gap\"\nradii = [\"20 mm\", \"20.38 mm\", \"21.96 "
                               "mm\", \"22.38 mm\"]\nheight = \"55 mm\"";

struct Expected {
    std::string text;
    std::string key;
    int line;
    std::string problem;
    std::string allowed;
    std::string suggestion;
};

void expect(const Expected& expected) {
    const casefile::Fault fault = only_fault(expected.text);
    EXPECT_EQ(fault.key, expected.key);
    ASSERT_FALSE(fault.places.empty()) << fault.text();
    EXPECT_EQ(fault.places.front().line, expected.line) << fault.text();
    EXPECT_TRUE(holds(fault.problem, expected.problem)) << fault.text();
    EXPECT_TRUE(holds(fault.allowed, expected.allowed)) << fault.text();
    EXPECT_EQ(fault.suggestion, expected.suggestion) << fault.text();
}

} // namespace

TEST(case_faults, unknown_key_names_the_nearest_and_the_valid_ones) {
    expect({with("height = \"42 mm\"", "height = \"42 mm\"\nheigth = \"1 mm\""), "geometry.heigth",
            6, "no such key", "type, bob_radius, cup_radius, height", "height"});
    expect({also("[solver]\naccuraccy = 1e-3\n"), "solver.accuraccy", 18, "no such key", "accuracy",
            "accuracy"});
}

TEST(case_faults, unknown_section_names_the_nearest) {
    expect({also("[solvr]\n"), "solvr", 17, "no such section", "solver", "solver"});
}

TEST(case_faults, key_of_another_section_is_recognised) {
    expect({with("height = \"42 mm\"", "height = \"42 mm\"\ndensity = \"1 kg/m^3\""),
            "geometry.density", 6, "no such key", "height", "fluid.density"});
    expect({"accuracy = 1e-3\n" + std::string{valid_case}, "accuracy", 1, "no such key", "solver",
            "solver.accuracy"});
}

TEST(case_faults, missing_key_points_at_its_section) {
    expect({with("height = \"42 mm\"\n", ""), "geometry.height", 1, "is missing",
            "a length, at least 1 nm and at most 1000 m, such as \"42 mm\"", ""});
    expect({with("type = \"single-gap\"\n", ""), "geometry.type", 1, "is missing",
            "single-gap, double-gap, din-bob, box", ""});
    expect({with("density = \"998.2 kg/m^3\"\n", ""), "fluid.density", 7, "is missing", "a density",
            ""});
}

TEST(case_faults, missing_sections_are_all_named) {
    const auto faults = faults_of("title = \"x\"\n");
    ASSERT_EQ(faults.size(), 3U);
    EXPECT_EQ(faults[0].key, "geometry");
    EXPECT_EQ(faults[1].key, "fluid");
    EXPECT_EQ(faults[2].key, "protocol");
    EXPECT_TRUE(holds(faults[0].allowed, "[geometry]"));
}

TEST(case_faults, bare_number_names_the_expected_unit) {
    expect({with("\"14 mm\"", "14"), "geometry.bob_radius", 3, "14 has no unit",
            "such as \"14 mm\"", ""});
    expect({with("\"14 mm\"", "\"14\""), "geometry.bob_radius", 3, "\"14\" has no unit", "a length",
            ""});
    expect({with("\"35 s\"", "35.5"), "protocol.duration", 15, "35.5 has no unit", "a time", ""});
}

TEST(case_faults, wrong_unit_says_what_it_is) {
    expect({with("\"14 mm\"", "\"14 s\""), "geometry.bob_radius", 3, "\"14 s\" is a time",
            "a length", ""});
    expect({with("\"14 mm\"", "\"14 mmm\""), "geometry.bob_radius", 3,
            "\"mmm\", which is not known", "a length", "\"mm\""});
    expect({with("100 1/s", "100 m"), "protocol.to", 14, "is a length",
            "a shear rate, an angular velocity or a speed", ""});
}

TEST(case_faults, wrong_type_says_what_it_is) {
    expect(
        {with("\"14 mm\"", "[\"14 mm\"]"), "geometry.bob_radius", 3, "is a list", "a length", ""});
    expect(
        {with("\"14 mm\"", "true"), "geometry.bob_radius", 3, "is true or false", "a length", ""});
    expect(
        {with("\"14 mm\"", "1979-05-27"), "geometry.bob_radius", 3, "is a date", "a length", ""});
    expect(
        {with("\"14 mm\"", "{ a = 1 }"), "geometry.bob_radius", 3, "is a table", "a length", ""});
    expect({with("points = 100", "points = \"100\""), "protocol.points", 16, "is a text",
            "a whole number", "100 without quotes"});
    expect({with("points = 100", "points = 1.5"), "protocol.points", 16,
            "1.5 is not a whole number", "a whole number", ""});
    expect({also("[output]\nfields = \"yes\"\n"), "output.fields", 18, "is a text", "true or false",
            ""});
    expect({"title = 5\n" + std::string{valid_case}, "title", 1, "5 is a number", "a text", ""});
    expect({"solver = 5\n" + std::string{valid_case}, "solver", 1, "5 is a whole number",
            "a section [solver]", ""});
    expect({"sweep = 5\n" + std::string{valid_case}, "sweep", 1, "5 is a whole number",
            "a section [sweep]", ""});
    expect({with("type = \"ramp\"", "type = 3"), "protocol.type", 13, "3 is not one of the names",
            "ramp, steps, segments", ""});
}

TEST(case_faults, values_out_of_bounds_are_refused) {
    expect({with("\"14 mm\"", "\"0 mm\""), "geometry.bob_radius", 3, "is not at least 1 nm",
            "1000 m", ""});
    expect({with("\"14 mm\"", "\"-14 mm\""), "geometry.bob_radius", 3, "is not at least 1 nm",
            "1 nm", ""});
    expect({with("1.0016 mPa.s", "0 mPa.s"), "fluid.viscosity", 9, "is not above 0 Pa.s",
            "above 0 Pa.s", ""});
    expect(
        {with("\"35 s\"", "\"0 s\""), "protocol.duration", 15, "is not above 0 s", "a time", ""});
    expect(
        {with("\"35 s\"", "\"-1 s\""), "protocol.duration", 15, "is not above 0 s", "a time", ""});
    expect({with("points = 100", "points = 0"), "protocol.points", 16, "0 is not at least 1",
            "at most 1000000", ""});
    expect({with("points = 100", "points = 1e9"), "protocol.points", 16, "1000000000 is not",
            "at most 1000000", ""});
    expect({with("points = 100", "points = 9223372036854775807"), "protocol.points", 16,
            "is not at least 1 and at most", "at most 1000000", ""});
    expect({with("100 1/s", "1e10 1/s"), "protocol.to", 14, "is not at least -1e9", "at most 1e9",
            ""});
}

TEST(case_faults, numbers_that_are_not_finite_are_refused) {
    expect({with("1.0016 mPa.s", "nan mPa.s"), "fluid.viscosity", 9, "finite number", "", ""});
    expect({with("1.0016 mPa.s", "inf mPa.s"), "fluid.viscosity", 9, "finite number", "", ""});
    expect(
        {with("1.0016 mPa.s", "1e999 mPa.s"), "fluid.viscosity", 9, "beyond the numbers", "", ""});
    expect({also("[solver]\naccuracy = inf\n"), "solver.accuracy", 18, "inf is not a finite number",
            "a number or a text in %", ""});
    expect({with("points = 100", "points = nan"), "protocol.points", 16, "not a finite number", "",
            ""});
}

TEST(case_faults, names_are_matched_with_the_nearest) {
    expect({with("single-gap", "singlegap"), "geometry.type", 2, "is not one of the names",
            "single-gap, double-gap, din-bob, box", "\"single-gap\""});
    expect({with("newtonian", "newton"), "fluid.model", 8, "is not one of the names",
            "herschel-bulkley", "\"newtonian\""});
    expect({also("[conversion]\ndefinition = \"iso3219\"\n"), "conversion.definition", 18,
            "is not one of the names", "\"bob-wall\", \"iso-3219\" or \"mean-radius\"",
            "\"iso-3219\""});
    expect({also("[conversion]\nend_factor = \"computd\"\n"), "conversion.end_factor", 18,
            "is a text", "\"computed\"", "\"computed\""});
}

TEST(case_faults, key_that_the_type_does_not_use_is_refused) {
    expect({with("height = \"42 mm\"", "height = \"42 mm\"\nlength_ratio = 3"),
            "geometry.length_ratio", 6, "is not used with type = \"single-gap\"", "bob_radius",
            ""});
    expect({with("viscosity = ", "yield_stress = \"1 Pa\"\nviscosity = "), "fluid.yield_stress", 9,
            "is not used with model = \"newtonian\"", "viscosity", ""});
    expect({with("points = 100", "points = 100\nhold = \"steady\""), "protocol.hold", 17,
            "is not used with type = \"ramp\"", "duration", ""});
    expect({with(ramp, "type = \"steps\"\nshear_rates = [\"1 1/s\"]\nstart = \"rest\""),
            "protocol.start", 15, "is not used with type = \"steps\"", "hold", ""});
}

TEST(case_faults, bob_wider_than_the_cup_names_both_lines) {
    const casefile::Fault fault = only_fault(with("\"15 mm\"", "\"1.3 cm\""));
    EXPECT_EQ(fault.key, "geometry.cup_radius");
    EXPECT_TRUE(holds(fault.problem, "wider than the bob"));
    ASSERT_EQ(fault.places.size(), 2U);
    EXPECT_EQ(fault.places[0].line, 4);
    EXPECT_EQ(fault.places[1].line, 3);
    EXPECT_TRUE(holds(fault.text(), "case.toml:4:14"));
    EXPECT_EQ(only_fault(with("\"15 mm\"", "\"14 mm\"")).key, "geometry.cup_radius");
}

TEST(case_faults, contradiction_is_silent_where_a_value_is_faulty_already) {
    EXPECT_EQ(only_fault(with("\"15 mm\"", "\"13 mmm\"")).places.size(), 1U);
    EXPECT_EQ(only_fault(with("cup_radius = \"15 mm\"\n", "")).problem, "is missing");
}

TEST(case_faults, eccentric_bob_keeps_off_the_cup_and_names_its_engine) {
    const std::string height = "height = \"42 mm\"";
    const std::string foam = "[solver]\nengine = \"openfoam\"\n";
    const auto offset = [&](const std::string& keys) { return with(height, height + "\n" + keys); };
    expect({offset("offset = \"1 mm\"") + foam, "geometry.offset", 6, "touch the cup", "below 1 mm",
            ""});
    expect({offset("offset = \"0.5 mm\""), "geometry.offset", 6, "bob in the middle",
            "engine = \"openfoam\"", ""});
    expect({offset("offset = \"0.5 mm\"\nends = true\nbottom_gap = \"5 mm\"") + foam,
            "geometry.offset", 6, "without ends", "ends = false", ""});
    EXPECT_TRUE(faults_of(offset("offset = \"0.99 mm\"") + foam).empty());
    EXPECT_TRUE(faults_of(offset("offset = \"0 mm\"")).empty());
}

TEST(case_faults, double_gap_radii_increase) {
    const auto radii = [](const std::string& list) {
        return with(single_gap, "type = \"double-gap\"\nradii = " + list + "\nheight = \"55 mm\"");
    };
    expect({radii("[\"20 mm\", \"19 mm\", \"22 mm\", \"23 mm\"]"), "geometry.radii", 3,
            "do not increase", "post < rotor inside", ""});
    expect({radii("[\"20 mm\", \"21 mm\", \"21 mm\", \"23 mm\"]"), "geometry.radii", 3,
            "do not increase", "", ""});
    expect({radii("[\"20 mm\", \"21 mm\", \"22 mm\"]"), "geometry.radii", 3, "the list has 3 items",
            "a list of 4", ""});
    expect({radii("\"20 mm\""), "geometry.radii", 3, "is not a list", "a list of 4", ""});
    const auto faults = faults_of(radii("[20, \"21 s\", \"22 mm\", \"23 mm\"]"));
    ASSERT_EQ(faults.size(), 2U) << "each item has its own";
    EXPECT_TRUE(holds(faults[0].problem, "20 has no unit"));
    EXPECT_TRUE(holds(faults[1].problem, "is a time"));
    EXPECT_LT(faults[0].places[0].column, faults[1].places[0].column);
}

TEST(case_faults, din_bob_contradictions) {
    const auto din = [](const std::string& more) { return with(single_gap, din_bob + more); };
    expect({din("cup_radius = \"15 mm\"\nradius_ratio = 1.08"), "geometry.cup_radius", 4,
            "the cup is given twice", "one of cup_radius and radius_ratio", ""});
    expect({din(""), "geometry.cup_radius", 1, "the cup is missing", "radius_ratio = 1.0847", ""});
    expect({din("cup_radius = \"13 mm\""), "geometry.cup_radius", 4, "wider than the bob", "", ""});
    expect(
        {din("radius_ratio = 1"), "geometry.radius_ratio", 4, "1 is not above 1", "above 1", ""});
    // 1/tan(60 deg) = 0.57735: the tip of the ISO cone.
    expect({din("radius_ratio = 1.08\nbottom_ratio = 0.5"), "geometry.bottom_ratio", 5,
            "tip, 0.57735 bob radii", "bottom_ratio > 1 / tan", ""});
    expect({din("radius_ratio = 1.08\ncone_angle = \"60 deg\""), "geometry.cone_angle", 5,
            "tip, 1.7321 bob radii", "", ""});
    expect({din("radius_ratio = 1.08\nshaft_ratio = 1.2"), "geometry.shaft_ratio", 5,
            "1.2 is not above 0 and below 1", "a number", ""});
    expect({din("radius_ratio = 1.08\ncone_angle = 120"), "geometry.cone_angle", 5,
            "120 has no unit", "an angle", ""});
    expect({din("radius_ratio = \"1.08\""), "geometry.radius_ratio", 4, "is a text", "a number",
            "1.08 without quotes"});
    EXPECT_TRUE(faults_of(din("radius_ratio = 1.08\ncone_angle = \"180 deg\"")).empty());
}

TEST(case_faults, conversion_contradictions) {
    const std::string box_case = with(single_gap, box);
    const std::string double_gap_case = with(single_gap, double_gap);
    for (const std::string& text : {box_case, double_gap_case})
        for (const char* definition : {"bob-wall", "mean-radius"}) {
            const auto fault =
                only_fault(text + "[conversion]\ndefinition = \"" + definition + "\"\n");
            EXPECT_EQ(fault.key, "conversion.definition");
            EXPECT_EQ(fault.places.size(), 2U);
            EXPECT_TRUE(holds(fault.allowed, "iso-3219")) << fault.text();
        }
    EXPECT_EQ(only_fault(box_case + "[conversion]\nend_factor = 1.0\n").key,
              "conversion.end_factor");
    EXPECT_EQ(only_fault(double_gap_case + "[conversion]\nend_factor = \"computed\"\n").key,
              "conversion.end_factor");
    EXPECT_EQ(only_fault(also("[conversion]\nend_factor = \"computed\"\n")).key,
              "conversion.end_factor");
    EXPECT_TRUE(faults_of(double_gap_case + "[conversion]\nend_factor = 1.02\n").empty());
    EXPECT_TRUE(faults_of(with(single_gap, din_bob + "radius_ratio = 1.08") +
                          "[conversion]\nend_factor = \"computed\"\n")
                    .empty());
}

TEST(case_faults, fluid_bounds_and_contradictions) {
    const auto fluid = [](const std::string& lines) { return with(newtonian, lines); };
    const std::string carreau =
        "model = \"carreau-yasuda\"\nzero_viscosity = \"1 Pa.s\"\ntime_constant = "
        "\"1 s\"\nflow_index = 0.5\n";
    const std::string cross =
        "model = \"cross\"\nzero_viscosity = \"1 Pa.s\"\ntime_constant = \"1 s\"\n";
    expect({fluid(carreau + "infinite_viscosity = \"2 Pa.s\""), "fluid.infinite_viscosity", 12,
            "above the one at rest", "infinite_viscosity <= zero_viscosity", ""});
    EXPECT_TRUE(faults_of(fluid(carreau + "infinite_viscosity = \"1 Pa.s\"")).empty());
    expect({fluid(cross + "flow_index = 1"), "fluid.flow_index", 11,
            "1 is not at least 0.01 and below 1", "a number", ""});
    expect({fluid(cross + "flow_index = 0"), "fluid.flow_index", 11,
            "0 is not at least 0.01 and below 1", "a number", ""});
    expect({fluid("model = \"power-law\"\nconsistency = \"0.5 Pa.s\"\nflow_index = 0.5"),
            "fluid.consistency", 9, "of a viscosity; a consistency's unit depends", "0.5 Pa.s^n",
            "\"Pa.s^n\""});
    expect({fluid("model = \"power-law\"\nconsistency = \"0.5 Pa.s^n\"\nflow_index = 0"),
            "fluid.flow_index", 10, "0 is not at least 0.01", "a number", ""});
    expect({fluid("model = \"bingham\"\nyield_stress = \"-1 Pa\"\nplastic_viscosity = \"1 cP\""),
            "fluid.yield_stress", 9, "is not at least 0 Pa", "a stress", ""});
    EXPECT_TRUE(faults_of(fluid("model = \"bingham\"\nyield_stress = \"0 Pa\"\nplastic_viscosity = "
                                "\"1 cP\""))
                    .empty());
}

TEST(case_faults, speeds_suit_the_drive) {
    const std::string box_case = with(single_gap, box);
    EXPECT_TRUE(holds(only_fault(with("100 1/s", "10 rpm", box_case)).problem, "does not turn"));
    EXPECT_TRUE(holds(only_fault(with("100 1/s", "10 mm/s")).problem, "the instrument turns"));
    EXPECT_TRUE(faults_of(with("100 1/s", "10 mm/s", box_case)).empty());
    EXPECT_TRUE(faults_of(with("100 1/s", "10 rpm")).empty());
    const casefile::Fault fault = only_fault(with(
        ramp,
        "type = \"segments\"\nsegments = [{to = \"1 1/s\", duration = \"1 s\"}, {to = \"1 m/s\", "
        "duration = \"1 s\"}]"));
    EXPECT_EQ(fault.key, "protocol.segments.2.to");
    EXPECT_TRUE(holds(only_fault(with(ramp, "type = \"steps\"\nwall_speeds = [\"1 m/s\"]")).problem,
                      "the instrument turns"));
}

TEST(case_faults, steps_contradictions) {
    const auto steps = [](const std::string& lines) {
        return with(ramp, "type = \"steps\"\n" + lines);
    };
    expect({steps(""), "protocol.shear_rates", 12, "the speeds are missing", "angular_velocities",
            ""});
    expect({steps("shear_rates = [\"1 1/s\"]\nangular_velocities = [\"1 rpm\"]"),
            "protocol.shear_rates", 14, "more than once", "one of", ""});
    expect({steps("shear_rates = []"), "protocol.shear_rates", 14, "the list has 0 items", "a list",
            ""});
    expect({steps("shear_rates = [\"0 1/s\", \"1 1/s\"]"), "protocol.shear_rates", 14,
            "a steady flow at speed 0", "a hold in seconds", ""});
    EXPECT_TRUE(faults_of(steps("shear_rates = [\"0 1/s\", \"1 1/s\"]\nhold = \"2 s\"")).empty());
    expect({steps("shear_rates = [\"1 rpm\"]"), "protocol.shear_rates", 14,
            "is an angular velocity", "a shear rate", ""});
    expect({steps("shear_rates = { from = \"0 1/s\", to = \"10 1/s\", count = 3 }"),
            "protocol.shear_rates.from", 14, "neither of them 0", "linear", ""});
    expect({steps("shear_rates = { from = \"1 1/s\", to = \"10 1/s\", count = 1e9 }"),
            "protocol.shear_rates.count", 14, "1000000000 is not", "at most 1000000", ""});
    expect(
        {steps(
             "shear_rates = { from = \"1 1/s\", to = \"10 1/s\", count = 3, spacing = \"logg\" }"),
         "protocol.shear_rates.spacing", 14, "is not one of the names", "\"log\" or \"linear\"",
         "\"log\""});
    expect({steps("shear_rates = [\"1 1/s\"]\nhold = \"0 s\""), "protocol.hold", 15,
            "is not above 0 s", "\"steady\"", ""});
    expect({steps("shear_rates = [\"1 1/s\"]\nhold = \"stedy\""), "protocol.hold", 15,
            "neither a quantity nor one of the names", "\"steady\"", "\"steady\""});
    expect({steps("shear_rates = [\"1 1/s\"]\nhold_strain = 5"), "protocol.hold_strain", 15,
            "is for a suspension", "[particles]", ""});
    EXPECT_EQ(faults_of(steps("shear_rates = [\"1 1/s\"]\nhold_strain = 5\nhold = \"1 s\"")).size(),
              2U);
}

TEST(case_faults, protocols_where_nothing_moves_or_too_much_is_asked) {
    expect({with("100 1/s", "0 1/s"), "protocol.to", 14, "nothing moves", "other than 0", ""});
    const auto segments = [](const std::string& list) {
        return with(ramp, "type = \"segments\"\nsegments = [" + list + "]");
    };
    expect({segments("{to = \"0 1/s\", duration = \"1 s\"}"), "protocol.segments", 14,
            "nothing moves", "", ""});
    expect(
        {segments(
             "{to = \"1 1/s\", duration = \"1 s\", points = 600000}, {to = \"0 1/s\", duration = "
             "\"1 s\", points = 600000}"),
         "protocol.segments", 14, "too many", "1000000", ""});
    expect({segments(""), "protocol.segments", 14, "0 items", "1 to 10000", ""});
    expect({segments("{to = \"1 1/s\", duration = \"0 s\"}"), "protocol.segments.1.duration", 14,
            "is not above 0 s", "a time", ""});
    expect({segments("{to = \"1 1/s\"}"), "protocol.segments.1.duration", 14, "is missing",
            "a time", ""});
    expect({segments("3"), "protocol.segments.1", 14, "3 is a whole number", "a table", ""});
}

TEST(case_faults, solver_contradictions) {
    EXPECT_EQ(only_fault(with(single_gap, box) + "[solver]\nmodel = \"axisymmetric\"\n").key,
              "solver.model");
    EXPECT_EQ(only_fault(also("[solver]\nmodel = \"radial\"\nsecondary_flow = true\n")).key,
              "solver.secondary_flow");
}

TEST(case_faults, suspension_bounds_and_contradictions) {
    const auto particles = [](const std::string& lines) {
        return also("[particles]\ndensity = \"5700 kg/m^3\"\nvolume_fraction = 0.05\n" + lines +
                    "\n");
    };
    EXPECT_TRUE(faults_of(particles("diameter = \"1.5 um\"")).empty());
    expect({particles(""), "particles.diameter", 17, "size of the particles is missing", "", ""});
    EXPECT_EQ(
        only_fault(particles("diameter = \"1 um\"\ndiameters = [{diameter = \"1 um\", share = 1}]"))
            .key,
        "particles.diameters");
    expect({particles("diameters = [{diameter = \"1 um\", share = 0.4}]"), "particles.diameters",
            20, "the shares sum to 0.4", "sum to 1", ""});
    expect({particles("diameter = \"1 um\"\ncontact = {}"), "particles.contact.stiffness", 21,
            "is missing", "a stiffness", ""});
    expect({particles(
                "diameter = \"1 um\"\ndlvo = {hamaker = \"1e-20 J\", zeta_potential = \"30 mV\"}"),
            "particles.dlvo.debye_length", 21, "thickness is missing", "ionic_strength", ""});
    EXPECT_EQ(only_fault(also("[coupling]\n")).key, "coupling");
    expect({particles("diameter = \"1 um\"\n[coupling]\ncells = [8, 8]"), "coupling.cells", 22,
            "the list has 2 items", "a list of 3", ""});
}

TEST(case_faults, all_faults_are_reported_at_once_in_order) {
    std::string text = with("\"14 mm\"", "14");
    text = with("height", "heigth", text);
    text = with("1.0016 mPa.s", "1.0016 mPa", text);
    text = with("\"35 s\"", "\"0 s\"", text);
    text = with("points = 100", "points = 1e9", text) + "[solvr]\n";
    const auto faults = faults_of(text);
    std::vector<std::string> keys;
    for (const auto& fault : faults)
        keys.push_back(fault.key);
    EXPECT_EQ(keys, (std::vector<std::string>{"geometry.height", "geometry.bob_radius",
                                              "geometry.heigth", "fluid.viscosity",
                                              "protocol.duration", "protocol.points", "solvr"}));
}

TEST(case_faults, syntax_faults_do_not_hide_the_others_nor_invent_missing_keys) {
    std::string text = with("\"14 mm\"", "14 mm");
    text = with("\"35 s\"", "\"0 s\"", text);
    const auto faults = faults_of(text);
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_EQ(faults[0].suggestion, "bob_radius = \"14 mm\"");
    EXPECT_EQ(faults[0].places.front().line, 3);
    EXPECT_EQ(faults[1].key, "protocol.duration");
}

TEST(case_faults, duplicate_key_reads_well) {
    const auto fault =
        only_fault(with("height = \"42 mm\"", "height = \"42 mm\"\nheight = \"43 mm\""));
    EXPECT_EQ(fault.problem, "height is given twice, first on line 5");
    EXPECT_EQ(fault.places.front().line, 6);
}

TEST(case_faults, override_is_named_in_place_of_a_line) {
    const auto fault = only_fault(std::string{valid_case}, {"geometry.cup_radius=13mm"});
    EXPECT_EQ(fault.places.at(0).source->name, "--set geometry.cup_radius=13mm");
    EXPECT_EQ(fault.places.at(1).line, 3);
    const auto unknown = only_fault(std::string{valid_case}, {"fluid.densty=1 kg/m^3"});
    EXPECT_EQ(unknown.suggestion, "density");
    EXPECT_TRUE(
        holds(only_fault(std::string{valid_case}, {"nothing"}).problem, "not an assignment"));
    EXPECT_TRUE(holds(only_fault(std::string{valid_case}, {"=3"}).problem, "not an assignment"));
    EXPECT_TRUE(
        holds(only_fault(std::string{valid_case}, {"protocol.to.x=3"}).problem, "not a table"));
    EXPECT_EQ(only_fault(std::string{valid_case}, {"sweep.vary=3"}).key, "sweep.vary");
    EXPECT_EQ(only_fault(std::string{valid_case}, {"geometry=3"}).key, "geometry");
}
