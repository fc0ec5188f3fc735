#include "app/ends_as_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

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
    for (const rheometry::EndEffect& row : table.rows) {
        nlohmann::ordered_json entry{{"angular_velocity_rad_s", row.speed},
                                     {"shear_rate_1_s", row.shear_rate},
                                     {"end_factor", row.end_factor},
                                     {"error", row.error},
                                     {"lower_bound", row.lower},
                                     {"upper_bound", row.upper}};
        if (std::isfinite(row.with_inertia)) {
            entry["end_factor_with_inertia"] = row.with_inertia;
            entry["error_with_inertia"] = row.with_inertia_error;
        }
        json["rows"].push_back(std::move(entry));
    }
    return json.dump(2) + "\n";
}

} // namespace searle::app
