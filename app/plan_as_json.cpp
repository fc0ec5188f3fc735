#include "app/plan_as_json.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace searle::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const std::optional<solvers::TaylorOnset>& taylor) {
    if (!taylor) {
        return nullptr;
    }
    return {{"critical_reynolds", number(taylor->critical_reynolds)},
            {"reynolds", number(taylor->reynolds)},
            {"largest_ratio", number(taylor->largest_ratio)},
            {"wave_number", number(taylor->wave_number)},
            {"onset_shear_rate_1_s",
             taylor->onset_shear_rate ? number(*taylor->onset_shear_rate) : Json(nullptr)},
            {"onset_angular_velocity_rad_s",
             taylor->critical_speed ? number(*taylor->critical_speed) : Json(nullptr)},
            {"relative_error", number(taylor->relative_error)},
            {"basis", taylor->basis}};
}

Json to_json(const solvers::RowForecast& row, const char* speed_key) {
    return {{"time_s", number(row.time)},
            {speed_key, number(row.speed)},
            {"shear_rate_1_s", number(row.shear_rate)},
            {"steady_stress_Pa", number(row.steady_stress)},
            {"taylor_ratio", number(row.taylor_ratio)},
            {"lag_share", number(row.lag_share)},
            {"regime", row.regime}};
}

Json to_json(const CasePlan& planned) {
    const solvers::Scene& scene = planned.source.scene;
    const solvers::Plan& plan = planned.plan;
    Json json = {{"case", planned.source.name},
                 {"title", scene.title},
                 {"hash", planned.source.hash},
                 {"geometry", scene.profile ? "profile" : geometry::name_of(scene.instrument)},
                 {"fluid", laws::flow::name_of(scene.fluid.law)},
                 {"accuracy", scene.solver.accuracy},
                 {"model", plan.model},
                 {"model_reason", plan.model_reason},
                 {"can_be_solved", plan.can_be_solved},
                 {"transient", plan.transient},
                 {"taylor", to_json(plan.taylor)},
                 {"items", Json::array()},
                 {"warnings", plan.warnings},
                 {"expected", {{"seconds", nullptr}, {"unknowns", nullptr}}},
                 {"regimes", Json::object()},
                 {"rows", Json::array()}};
    if (plan.can_be_solved) {
        json["expected"] = {{"seconds", number(plan.expected_seconds)},
                            {"unknowns", plan.expected_unknowns}};
    }
    for (const solvers::PlanItem& item : plan.items) {
        json["items"].push_back(
            {{"what", item.what}, {"solved", item.solved}, {"reason", item.reason}});
    }
    const char* speed_key =
        geometry::rotates(scene.instrument) ? "angular_velocity_rad_s" : "wall_speed_m_s";
    std::map<std::string, long> regimes;
    for (const solvers::RowForecast& row : plan.rows) {
        ++regimes[row.regime];
        json["rows"].push_back(to_json(row, speed_key));
    }
    for (const auto& [regime, count] : regimes) {
        json["regimes"][regime] = count;
    }
    return json;
}

} // namespace

std::string plans_as_json(const std::vector<CasePlan>& plans) {
    Json all = Json::array();
    for (const CasePlan& planned : plans) {
        all.push_back(to_json(planned));
    }
    const Json& shown = plans.size() > 1 ? all : all.front();
    return shown.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace searle::app
