#include "app/starting_case.hpp"
#include "tests/app/case_texts.hpp"

#include "places.hpp"
#include <filesystem>

#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

using namespace searle;
using namespace searle::app;

namespace {

// Odd values, so that a lost digit shows.
const std::vector<std::string> geometries{
    "type = \"single-gap\"\nbob_radius = \"13.7 mm\"\ncup_radius = \"0.61 inch\"\nheight = \"41.3 "
    "mm\"\n",
    "type = \"double-gap\"\nradii = [\"20 mm\", \"20.38 mm\", \"21.96 mm\", \"22.38 mm\"]\nheight "
    "= \"1.7 inch\"\n",
    "type = \"din-bob\"\nbob_radius = \"13.33 mm\"\nradius_ratio = 1.0847\ncone_angle = \"119.3 "
    "deg\"\n",
    "type = \"din-bob\"\nbob_radius = \"13.33 mm\"\ncup_radius = \"15.01 mm\"\nshaft_ratio = "
    "0.31\n",
    "type = \"box\"\ngap = \"0.97 mm\"\nlength = \"88.1 mm\"\nwidth = \"1.9 inch\"\n"};

const std::vector<std::string> fluids{
    "model = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"\n",
    "model = \"bingham\"\nyield_stress = \"4.7 lbf/ft^2\"\nplastic_viscosity = \"21.3 cP\"\n",
    "model = \"power-law\"\nconsistency = \"513 mPa.s^n\"\nflow_index = 0.47\n",
    "model = \"herschel-bulkley\"\nyield_stress = \"5.1 Pa\"\nconsistency = \"0.53 "
    "lbf.s^n/ft^2\"\nflow_index = 1.3\n",
    "model = \"casson\"\nyield_stress = \"0 Pa\"\nplastic_viscosity = \"21.3 cP\"\n",
    "model = \"carreau-yasuda\"\nzero_viscosity = \"1.3 Pa.s\"\ntime_constant = \"0.7 "
    "min\"\nflow_index = 0.41\n",
    "model = \"cross\"\nzero_viscosity = \"1.3 Pa.s\"\ninfinite_viscosity = \"1.1 "
    "cP\"\ntime_constant = \"0.7 min\"\nflow_index = 0.41\n"};

const std::vector<std::string> protocols{
    "type = \"ramp\"\nfrom = \"-3.3 1/s\"\nto = \"100.7 1/s\"\nduration = \"0.59 min\"\npoints = "
    "17\nstart = \"rest\"\n",
    "type = \"steps\"\nshear_rates = [\"1.1 1/s\", \"-10.3 1/s\"]\n",
    "type = \"steps\"\nshear_rates = { from = \"0.13 1/s\", to = \"1013 1/s\", count = 31 }\nhold "
    "= \"0.17 min\"\n",
    "type = \"segments\"\nsegments = [{ to = \"100.7 1/s\", duration = \"0.59 min\" }, { to = \"-3 "
    "1/s\", duration = \"7 s\", points = 3 }]\n"};

std::string assembled(const std::string& geometry, const std::string& fluid,
                      const std::string& protocol, const std::string& more = "") {
    return "title = \"A \\\"quoted\\\" title, \\u00e4 \\\\ \\t end\"\n[geometry]\n" + geometry +
           "[fluid]\n" + fluid + "density = \"0.9982 g/cm^3\"\n[protocol]\n" + protocol + more;
}

bool same_bits(const laws::flow::AnyFlowLaw& one, const laws::flow::AnyFlowLaw& other) {
    for (const double rate : {0.1, 1.0, 37.0, 1e4})
        if (laws::flow::stress(one, rate) != laws::flow::stress(other, rate))
            return false;
    return one.index() == other.index();
}

void expect_round_trip(const std::string& text) {
    const Case first = read_text(text);
    const Case second = read_text(first.resolved_toml);
    EXPECT_EQ(first.resolved_toml, second.resolved_toml);
    EXPECT_EQ(first.hash, second.hash);
    EXPECT_TRUE(same_bits(first.scene.fluid.law, second.scene.fluid.law)) << first.resolved_toml;
    EXPECT_EQ(first.scene.fluid.density, second.scene.fluid.density);
    EXPECT_EQ(first.scene.title, second.scene.title);
}

} // namespace

TEST(case_round_trip, every_geometry_model_and_protocol) {
    int cases = 0;
    for (const std::string& geometry : geometries)
        for (const std::string& fluid : fluids)
            for (const std::string& protocol : protocols) {
                SCOPED_TRACE(geometry + fluid + protocol);
                expect_round_trip(assembled(geometry, fluid, protocol));
                ++cases;
            }
    EXPECT_EQ(cases, 5 * 7 * 4);
}

TEST(case_round_trip, every_kind_of_drive_speed) {
    const std::string ramp =
        "type = \"ramp\"\nfrom = \"1.3 rpm\"\nto = \"33.3 rpm\"\nduration = \"1 s\"\n";
    const std::string wall =
        "type = \"ramp\"\nfrom = \"1.3 mm/s\"\nto = \"1 inch/s\"\nduration = \"1 s\"\n";
    expect_round_trip(assembled(geometries[0], fluids[0], ramp));
    expect_round_trip(assembled(geometries[4], fluids[0], wall));
    expect_round_trip(
        assembled(geometries[0], fluids[0],
                  "type = \"steps\"\nangular_velocities = [\"1.3 rpm\", \"7 rpm\"]\n"));
    expect_round_trip(assembled(geometries[4], fluids[0],
                                "type = \"steps\"\nwall_speeds = { from = \"1 mm/s\", to = \"7 "
                                "mm/s\", count = 3, spacing = \"linear\" }\n"));
}

TEST(case_round_trip, optional_sections) {
    expect_round_trip(assembled(
        geometries[3], fluids[3], protocols[1],
        "[conversion]\nend_factor = \"computed\"\n[solver]\naccuracy = \"0.013 "
        "%\"\nsecondary_flow = false\n"
        "model = \"3d\"\nengine = \"openfoam\"\napplication = \"pisoFoam\"\nprocessors = 3\n"
        "time_step = \"1.3 ms\"\nviscosity_cap = \"17 Pa.s\"\n[output]\nfields = true\n"
        "[mesh]\ncells_across_gap = 20\nwedge_angle = \"5 deg\"\norder = 2\n"));
    expect_round_trip(assembled(
        geometries[4], fluids[0],
        "type = \"steps\"\nshear_rates = [\"7 1/s\"]\nhold_strain = 5.1\ndiscard_strain = 1.2\n",
        "[particles]\ndiameters = [{ diameter = \"1.1 um\", share = \"30 %\" }, { diameter = \"2 "
        "um\", share = "
        "0.7 }]\ndensity = \"5.7 g/cm^3\"\nvolume_fraction = \"4.68 %\"\nboundary = "
        "\"lees-edwards\"\n"
        "contact = { stiffness = \"1e-2 N/m\", damping = \"3e-9 kg/s\" }\n"
        "dlvo = { hamaker = \"6e-20 J\", zeta_potential = \"32 mV\", ionic_strength = \"1.3 mM\" "
        "}\n"
        "brownian = true\ntemperature = \"20 degC\"\ngravity = true\nshear_modulus = \"77 GPa\"\n"
        "poisson_ratio = 0.3\ntime_step = \"1.3 ns\"\nseed = 8999999999999999\n[coupling]\ncells = "
        "[4, 8, 16]\n"));
}

TEST(case_round_trip, every_default_is_written_out) {
    const std::string text = read_text(std::string{valid_case}).resolved_toml;
    for (const char* line :
         {"title = \"\"", "bob_radius = \"0.014 m\"", "viscosity = \"0.0010016 Pa.s\"",
          "from = \"0 1/s\"", "start = \"steady\"", "definition = \"bob-wall\"", "end_factor = 1",
          "engine = \"native\"", "model = \"auto\"", "accuracy = 0.001",
          "secondary_flow = \"auto\"", "fields = false", "wedge_angle = \"auto\""})
        EXPECT_NE(text.find(line), std::string::npos) << line;
}

TEST(starting_case, passes_the_check_for_every_geometry) {
    ASSERT_EQ(geometry_names().size(), 5U);
    for (const std::string& geometry : geometry_names()) {
        const std::string text = starting_case(geometry);
        const Case one = read_text(text);
        // A profile is meshed only; it is no instrument that the conversions know.
        if (geometry != "profile") {
            EXPECT_EQ(geometry::name_of(one.scene.instrument), geometry);
        }
        expect_round_trip(text);
        EXPECT_NE(text.find("# single-gap | double-gap | din-bob | box"), std::string::npos);
    }
    EXPECT_NE(starting_case("din-bob").find("radius_ratio = 1.0847"), std::string::npos);
    EXPECT_NE(starting_case("din-bob").find("cone_angle = \"120 deg\""), std::string::npos);
    EXPECT_EQ(starting_case("box").find("end_factor"), std::string::npos) << "the box has none";
}

TEST(cases, shipped_cases_are_valid) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator{std::filesystem::path{SEARLE_SOURCE_DIR} / "cases"}) {
        if (entry.path().extension() != ".toml")
            continue;
        ++files;
        try {
            EXPECT_FALSE(read_cases(entry.path()).empty());
        } catch (const CaseError& error) {
            ADD_FAILURE() << error.what();
        }
    }
    EXPECT_GE(files, 4);
}

// Whatever a file holds, reading ends with a case or with faults that can be printed.
TEST(case_mutations, never_crash) {
    std::mt19937 random{20261122};
    const std::string sweep =
        "[sweep]\nvary = { \"geometry.cup_radius\" = [\"15 mm\", \"16 mm\"] }\n"
        "[[sweep.runs]]\nname = \"a\"\nset = { protocol.points = 3 }\n";
    const std::string signs = "\"'[]{}=.#\n\t 0129eE-+_,azn\\\x01\x80\xff";
    const std::vector<std::string> words{"nan",     "inf",
                                         "\"\"",    "[[",
                                         "]]",      "1e400",
                                         "= {}",    "\"14 mm\"",
                                         "true",    "\n[geometry]\n",
                                         "\\u0000", "99999999999999999999"};
    int faulty = 0;
    for (int draw = 0; draw < 6000; ++draw) {
        std::string text = assembled(geometries[random() % 5], fluids[random() % 7],
                                     protocols[random() % 4], draw % 3 == 0 ? sweep : "");
        for (auto changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
            const std::size_t at = random() % text.size();
            switch (random() % 5) {
            case 0:
                text.resize(at);
                break;
            case 1:
                text[at] = signs[random() % signs.size()];
                break;
            case 2:
                text.insert(at, 1, signs[random() % signs.size()]);
                break;
            case 3:
                text.erase(at, 1 + random() % 20);
                break;
            default:
                text.insert(at, words[random() % words.size()]);
                break;
            }
        }
        const auto faults = faults_of(text);
        faulty += faults.empty() ? 0 : 1;
        for (const auto& fault : faults)
            ASSERT_FALSE(fault.text().empty());
    }
    EXPECT_GT(faulty, 4000);
}
