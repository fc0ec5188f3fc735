#include "app/plan_as_json.hpp"
#include "app/plan_as_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace searle::app {
namespace {

CasePlan planned(const geometry::Instrument& instrument) {
    CasePlan result;
    result.source.name = "water";
    result.source.scene.title = "Water";
    result.source.scene.instrument = instrument;
    result.source.scene.fluid = {laws::flow::Newtonian{1.0016e-3}, 998.2};
    result.source.scene.protocol.program = rheometry::Ramp{{0.0}, {300.0}, 35.0, 100};
    result.plan = solvers::make_plan(result.source.scene);
    return result;
}

const geometry::Instrument single_gap = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
const geometry::Instrument double_gap =
    geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.055};
const geometry::Instrument din_bob = geometry::DinBob{0.014, 0.0152};
const geometry::Instrument box = geometry::Box{0.001, 0.02, 0.02};

// The contract: taylor.critical_reynolds and taylor.reynolds for every geometry with cylinders.
TEST(PlanAsJson, cylinders_always_have_their_taylor_numbers) {
    for (const geometry::Instrument& instrument : {single_gap, double_gap, din_bob}) {
        const auto json = nlohmann::json::parse(plans_as_json({planned(instrument)}));
        EXPECT_GT(json.at("taylor").at("critical_reynolds").get<double>(), 1.0);
        EXPECT_GT(json.at("taylor").at("reynolds").get<double>(), 0.0);
    }
    EXPECT_TRUE(nlohmann::json::parse(plans_as_json({planned(box)})).at("taylor").is_null());
}

TEST(PlanAsJson, numbers_survive_to_the_last_bit) {
    const CasePlan plan = planned(single_gap);
    const auto json = nlohmann::json::parse(plans_as_json({plan}));
    ASSERT_EQ(json.at("rows").size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(json["rows"][i]["steady_stress_Pa"].get<double>(),
                  plan.plan.rows[i].steady_stress);
        EXPECT_EQ(json["rows"][i]["regime"].get<std::string>(), plan.plan.rows[i].regime);
    }
    EXPECT_EQ(json["taylor"]["critical_reynolds"].get<double>(),
              plan.plan.taylor->critical_reynolds);
}

TEST(PlanAsJson, the_box_moves_its_wall_and_several_cases_are_a_list) {
    const auto json = nlohmann::json::parse(plans_as_json({planned(box), planned(single_gap)}));
    ASSERT_TRUE(json.is_array());
    EXPECT_TRUE(json[0]["rows"][0].contains("wall_speed_m_s"));
    EXPECT_TRUE(json[1]["rows"][0].contains("angular_velocity_rad_s"));
}

TEST(PlanAsJson, a_case_that_cannot_be_solved_has_no_expected_cost) {
    CasePlan plan = planned(single_gap);
    plan.source.scene.solver.model = solvers::Model::three_dimensional;
    plan.plan = solvers::make_plan(plan.source.scene);
    const auto json = nlohmann::json::parse(plans_as_json({plan}));
    EXPECT_FALSE(json["can_be_solved"].get<bool>());
    EXPECT_TRUE(json["expected"]["seconds"].is_null());
}

TEST(PlanAsText, sentences_fit_a_hundred_characters_and_the_model_comes_first) {
    for (const geometry::Instrument& instrument : {single_gap, double_gap, din_bob, box}) {
        std::istringstream text(plan_as_text(planned(instrument)));
        std::string line;
        std::getline(text, line);
        EXPECT_EQ(line, "Water (water)");
        std::getline(text, line);
        EXPECT_EQ(line.find("  model"), 0u);
        while (std::getline(text, line)) {
            const bool is_table_row = line.find(" to ") < 20;
            EXPECT_LE(line.size(), is_table_row ? 118u : 100u) << line;
            EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
        }
    }
}

TEST(PlanAsText, neighbouring_rows_of_one_regime_share_a_line) {
    const std::string text = plan_as_text(planned(single_gap));
    EXPECT_NE(text.find("  1 to 59 "), std::string::npos) << text;
    EXPECT_NE(text.find("  60 to 100 "), std::string::npos) << text;
    EXPECT_NE(text.find("lag+taylor-vortices\n"), std::string::npos) << text;
}

} // namespace
} // namespace searle::app
