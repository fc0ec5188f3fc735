#include "tests/app/running.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

// `searle fit --case`, the real program on files as a laboratory has them.

namespace {

using nlohmann::json;
using searle::app::testing::Outcome;
using searle::app::testing::searle;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::string single_gap = R"(
[geometry]
type = "single-gap"
bob_radius = "10 mm"
cup_radius = "20 mm"
height = "60 mm"
[fluid]
model = "newtonian"
viscosity = "1 Pa.s"
density = "1000 kg/m^3"
[protocol]
type = "steps"
shear_rates = ["1 1/s"]
)";

/// Power law 2 Pa s^0.5, 0.5 in the wide gap, by the closed form tau = K (2 omega n' ...)^n with
/// omega = rate/2 (1 - delta^(-2/n)) n; 0.3 % of scatter by a fixed sequence.
std::string power_law_rows(const std::string& header, bool with_times) {
    std::ostringstream text;
    text.precision(12);
    text << header << '\n';
    for (int k = 0; k < 20; ++k) {
        const double rate = 0.1 * std::pow(10.0, 0.15 * k);
        const double speed = 0.5 * 0.5 * rate * (1.0 - std::pow(2.0, -4.0));
        const double stress = 2.0 * std::sqrt(rate) * (1.0 + 0.003 * std::sin(7.0 * k * k));
        if (with_times)
            text << 30 * k << ',';
        text << speed << ',' << 2.0 * std::numbers::pi * 0.010 * 0.010 * 0.060 * stress << '\n';
    }
    return text.str();
}

class FitInstrumentVerb : public ::testing::Test {
protected:
    FitInstrumentVerb() {
        write_text(folder / "gap.toml", single_gap);
        write_text(folder / "lab.csv", power_law_rows("angular_velocity_rad_s,torque_N_m", false));
    }
    Outcome fit(std::vector<std::string> words) const {
        words.insert(words.begin(), {"fit", "--case", "gap.toml"});
        return searle(words, folder.path());
    }

    TemporaryFolder folder;
};

TEST_F(FitInstrumentVerb, json_holds_the_law_the_conventional_route_and_the_inversion) {
    const Outcome outcome = fit({"lab.csv", "--model", "power-law", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json found = json::parse(outcome.out);
    const json& consistency = found.at("parameters").at("consistency");
    EXPECT_NEAR(consistency.at("value").get<double>(), 2.0, 0.01);
    // Rate at the bob 2 omega delta^2/(delta^2 - 1) of a Newtonian fluid is 2/3 of the true one.
    EXPECT_GT(found.at("conventional").at("consistency").at("value").get<double>(), 2.3);
    const json& rows = found.at("model_free").at(0).at("rows");
    ASSERT_EQ(rows.size(), 20U);
    int within = 0;
    for (const json& row : rows) {
        const double stress = row.at("rotor_stress_Pa").get<double>();
        EXPECT_EQ(row.at("branch"), "sheared");
        EXPECT_NEAR(row.at("law_rate_1_s").get<double>() / std::pow(stress / 2.0, 2.0), 1.0, 0.03);
        within += row.at("ci95")[0].get<double>() < row.at("law_rate_1_s").get<double>() &&
                          row.at("law_rate_1_s").get<double>() < row.at("ci95")[1].get<double>()
                      ? 1
                      : 0;
    }
    EXPECT_GE(within, 16); // 95 % of 20, three binomial standard deviations
    EXPECT_TRUE(found.at("loops").empty());
}

TEST_F(FitInstrumentVerb, an_eccentric_bob_is_refused) {
    const Outcome outcome = searle({"fit", "lab.csv", "--case", "gap.toml", "--set",
                                    "geometry.offset=1 mm", "--set", "solver.engine=openfoam"},
                                   folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "geometry.offset")) << outcome.err;
}

TEST_F(FitInstrumentVerb, the_inversion_stands_in_the_table_and_as_csv) {
    const Outcome table = fit({"lab.csv", "--model", "power-law"});
    EXPECT_TRUE(holds(table.out, "without a law")) << table.out;
    EXPECT_TRUE(holds(table.out, "12 of 20 rows"));
    EXPECT_TRUE(holds(table.out, "conventional:"));
    const Outcome rows = fit({"lab.csv", "--model", "power-law", "--model-free", "--csv"});
    EXPECT_TRUE(rows.out.starts_with("series,line,angular_velocity_rad_s,rotor_stress_Pa"));
    EXPECT_EQ(std::count(rows.out.begin(), rows.out.end(), '\n'), 21);
}

TEST_F(FitInstrumentVerb, predictions_and_designs_come_through_the_instrument) {
    const Outcome outcome =
        fit({"lab.csv", "--model", "power-law", "--predict", "4", "--design", "3", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json found = json::parse(outcome.out);
    const json& point = found.at("predictions").at(0);
    EXPECT_NEAR(point.at("shear_stress_Pa").get<double>(), 4.0, 0.02);
    EXPECT_LT(point.at("confidence95")[0].get<double>(), 4.01);
    EXPECT_LT(point.at("prediction95")[0].get<double>(), point.at("confidence95")[0].get<double>());
    ASSERT_EQ(found.at("design").size(), 4U);
    std::string names;
    for (const json& design : found.at("design")) {
        names += design.at("geometry").get<std::string>() + ";";
        EXPECT_LT(design.at("standard_error_ratio").at("flow_index").get<double>(), 1.0);
        EXPECT_GT(design.at("points").at(0).at("speed").get<double>(), 0.0);
    }
    for (const char* name :
         {"single-gap, 10/20 mm, 60 mm high (the case's)", "double-gap", "din-bob", "box"})
        EXPECT_TRUE(holds(names, name)) << names;
}

TEST_F(FitInstrumentVerb, a_page_shows_all_of_it) {
    const Outcome outcome = fit({"lab.csv", "--model", "power-law", "-o", "fit.html"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string page = text_of(folder / "fit.html");
    for (const char* part : {"true rate at the rotor", "conventional route", "converted"})
        EXPECT_TRUE(holds(page, part)) << part;
}

TEST_F(FitInstrumentVerb, the_ends_of_a_bob_are_computed_unless_they_are_fixed) {
    std::string bob = single_gap;
    const std::string gap = bob.substr(bob.find("type"), bob.find("[fluid]") - bob.find("type"));
    bob.replace(bob.find("type"), gap.size(),
                "type = \"din-bob\"\nbob_radius = \"14 mm\"\ncup_radius = \"15.2 mm\"\n");
    write_text(folder / "gap.toml", bob);
    const Outcome computed = fit({"lab.csv", "--model", "newtonian", "--json"});
    ASSERT_EQ(computed.exit_code, 0) << computed.err;
    const json ends = json::parse(computed.out).at("ends");
    ASSERT_EQ(ends.size(), 1U);
    // TRIOS' 14/15.2/42 mm bob, Newtonian: 1.0893 (physics of the bob, known value).
    EXPECT_NEAR(ends[0].at("end_factor")[0].get<double>(), 1.0893, 5e-4);
    EXPECT_EQ(ends[0].at("conventional"), 1.1);
    const Outcome fixed = fit({"lab.csv", "--model", "newtonian", "--json", "--fixed-ends"});
    EXPECT_TRUE(json::parse(fixed.out).at("ends").empty());
}

// What a laboratory's files have wrong: a result that says so, or an error that names the place.
TEST_F(FitInstrumentVerb, wrong_rows_are_left_out_with_their_lines) {
    std::string text = text_of(folder / "lab.csv");
    text += "0,1e-5\n1,-1e-4\n2,1e308\n";
    write_text(folder / "lab.csv", text);
    const Outcome outcome = fit({"lab.csv", "--model", "power-law"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "(line 22): at rest")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "(line 23): the shear stress has not the sign")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "(line 24): ")) << outcome.err;
}

TEST_F(FitInstrumentVerb, data_without_a_usable_row_are_an_error_with_the_reason) {
    write_text(folder / "lab.csv", "angular_velocity_rad_s,torque_N_m\n1,1e308\n2,1e308\n");
    const Outcome outcome = fit({"lab.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "none of the 2 rows can be used")) << outcome.err;
}

TEST_F(FitInstrumentVerb, times_that_do_not_increase_are_told) {
    std::string text = power_law_rows("time_s,angular_velocity_rad_s,torque_N_m", true);
    text.replace(text.find("\n30,"), 4, "\n0,");
    write_text(folder / "lab.csv", text);
    std::string ramp = single_gap;
    ramp.replace(ramp.find("type = \"steps\""), std::string::npos,
                 "type = \"ramp\"\nfrom = \"0 1/s\"\nto = \"80 1/s\"\nduration = \"600 s\"\n"
                 "points = 20\n");
    write_text(folder / "gap.toml", ramp);
    const Outcome outcome = fit({"lab.csv", "--model", "power-law"});
    EXPECT_TRUE(holds(outcome.out, "times do not increase")) << outcome.out;
}

/// The times of speeds that are held and then jump are no ramp, whose inertia would be taken out.
TEST_F(FitInstrumentVerb, times_of_steps_change_nothing) {
    write_text(folder / "timed.csv",
               power_law_rows("time_s,angular_velocity_rad_s,torque_N_m", true));
    const auto consistency = [&](const char* file) {
        return json::parse(fit({file, "--model", "power-law", "--json"}).out)
            .at("parameters")
            .at("consistency")
            .at("value")
            .get<double>();
    };
    EXPECT_EQ(consistency("timed.csv"), consistency("lab.csv"));
}

} // namespace
