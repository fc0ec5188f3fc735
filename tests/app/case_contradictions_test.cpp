#include "tests/app/expected_fault.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

// Settings that do not go together, section by section; what a single key may be is in
// case_faults_test.cpp.

using namespace searle;
using namespace searle::app;

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
    const std::string hertz = "diameter = \"1 um\"\ncontact = { model = \"hertz\" }";
    expect({particles(hertz + "\npoisson_ratio = 0.3"), "particles.contact", 21,
            "needs the shear_modulus", "shear_modulus and poisson_ratio", ""});
    expect({particles(hertz + "\nshear_modulus = \"1 GPa\""), "particles.contact", 21,
            "needs the poisson_ratio", "shear_modulus and poisson_ratio", ""});
    expect({particles("diameter = \"1 um\"\ncontact = { model = \"hertz\", stiffness = \"1 N/m\" "
                      "}\nshear_modulus = \"1 GPa\"\npoisson_ratio = 0.3"),
            "particles.contact.stiffness", 21, "hertz takes its stiffness", "shear_modulus", ""});
    expect({particles(
                "diameter = \"1 um\"\ndlvo = {hamaker = \"1e-20 J\", zeta_potential = \"30 mV\"}"),
            "particles.dlvo.debye_length", 21, "thickness is missing", "ionic_strength", ""});
    EXPECT_EQ(only_fault(also("[coupling]\n")).key, "coupling");
    expect({particles("diameter = \"1 um\"\n[coupling]\ncells = [8, 8]"), "coupling.cells", 22,
            "the list has 2 items", "a list of 3", ""});
}
