#include "app/ends_as_json.hpp"

#include <nlohmann/json.hpp>

namespace searle::app {

std::string ends_as_json(const solvers::axisymmetric::EndEffectTable& table, const Case& source) {
    nlohmann::ordered_json json;
    json["case"] = source.file.filename().string();
    json["geometry"] = geometry::name_of(source.scene.instrument);
    json["fluid"] = laws::flow::name_of(source.scene.fluid.law);
    json["accuracy_asked"] = source.scene.solver.accuracy;
    json["reached"] = table.reached;
    json["interrupted"] = table.interrupted;
    json["rows"] = nlohmann::ordered_json::array();
    for (const rheometry::EndEffect& row : table.rows)
        json["rows"].push_back({{"angular_velocity_rad_s", row.speed},
                                {"shear_rate_1_s", row.shear_rate},
                                {"end_factor", row.end_factor},
                                {"error", row.error},
                                {"lower_bound", row.lower},
                                {"upper_bound", row.upper}});
    return json.dump(2) + "\n";
}

} // namespace searle::app
