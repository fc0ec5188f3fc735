#include "tests/app/expected_fault.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace searle;
using namespace searle::app;

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
