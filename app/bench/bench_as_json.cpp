#include "app/bench/bench_text.hpp"
#include "app/bench/work_precision.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace searle::app::bench {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json point_json(const Measurement& point) {
    return {{"code", point.code},
            {"setting", point.setting},
            {"asked", number(point.asked)},
            {"true_error", number(point.true_error)},
            {"error_estimate", number(point.estimate)},
            {"cpu_median_s", number(point.cpu_median)},
            {"cpu_least_s", number(point.cpu_least)},
            {"repeats", point.repeats},
            {"unknowns", number(point.unknowns)},
            {"peak_MiB", number(point.peak_MiB)},
            {"remark", point.remark}};
}

} // namespace

std::string bench_json(const BenchResult& result) {
    Json scenes = Json::array();
    for (const SceneResult& scene : result.scenes) {
        Json points = Json::array();
        for (const Measurement& point : scene.points)
            points.push_back(point_json(point));
        scenes.push_back({{"name", scene.name},
                          {"title", scene.title},
                          {"kind", scene.kind},
                          {"reference", scene.reference},
                          {"reference_error", number(scene.reference_error)},
                          {"whole_program_cpu_s", number(scene.whole_program)},
                          {"cost_unit", scene.cost_unit},
                          {"points", std::move(points)}});
    }
    Json ratios = Json::array();
    for (const Ratio& ratio : ratios_of(result))
        ratios.push_back({{"scene", ratio.scene},
                          {"peer", ratio.peer},
                          {"error", number(ratio.error)},
                          {"peer_cpu_s", number(ratio.peer_cpu)},
                          {"searle_cpu_s", number(ratio.own_cpu)},
                          {"ratio", number(ratio.ratio)},
                          {"lower_bound", ratio.at_least}});
    const Json json = {{"version", result.version},         {"created", result.created},
                       {"machine", result.machine},         {"quick", result.quick},
                       {"interrupted", result.interrupted}, {"scenes", std::move(scenes)},
                       {"ratios", std::move(ratios)},       {"notes", result.notes}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace searle::app::bench
