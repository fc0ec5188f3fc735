#include "app/fit_record.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace searle::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json matrix(const std::vector<double>& entries, std::size_t size) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < size; ++i) {
        Json row = Json::array();
        for (std::size_t k = 0; k < size; ++k)
            row.push_back(number(entries[i * size + k]));
        rows.push_back(std::move(row));
    }
    return rows;
}

Json parameters(const std::vector<fit::Estimate>& estimates) {
    Json json = Json::object();
    for (const fit::Estimate& estimate : estimates)
        json[estimate.parameter.key] = {
            {"value", number(estimate.value)},
            {"unit", estimate.parameter.unit},
            {"standard_error", number(estimate.standard_error)},
            {"ci95", Json::array({number(estimate.low), number(estimate.high)})},
            {"at_bound", estimate.at_bound},
            {"held", estimate.parameter.held}};
    return json;
}

Json residuals(const CurveRecord& curve, const fit::FitResult& result) {
    Json list = Json::array();
    for (const double residual : result.residuals)
        list.push_back(number(residual));
    Json json = {{"rms_relative", number(result.rms_relative)},
                 {curve.through_instrument ? "rms_N_m" : "rms_Pa", number(result.rms_absolute)},
                 {"standard_deviation", number(result.residual_deviation)},
                 {"sum_of_squares", number(result.sum_of_squares)},
                 {"r_squared", number(result.determination)},
                 {"runs", nullptr},
                 {"weighted", std::move(list)}};
    if (result.runs)
        json["runs"] = {{"count", result.runs->runs},
                        {"expected", number(result.runs->expected_runs)},
                        {"p", number(result.runs->probability)}};
    return json;
}

Json model_free(const CurveRecord& curve) {
    Json list = Json::array();
    for (const ModelFreeRecord& record : curve.model_free) {
        Json rows = Json::array();
        for (const ModelFreeRow& row : record.rows)
            rows.push_back({{"line", row.line},
                            {"angular_velocity_rad_s", number(row.speed)},
                            {"rotor_stress_Pa", number(row.stress)},
                            {"rotor_rate_1_s", number(row.rate)},
                            {"ci95", Json::array({number(row.low), number(row.high)})},
                            {"branch", name_of(row.branch)},
                            {"law_rate_1_s", number(row.law_rate)}});
        Json json = {{"series", record.series}, {"yield_stress_Pa", nullptr}, {"rows", rows}};
        if (record.yield_stress)
            json["yield_stress_Pa"] = {{"value", *record.yield_stress},
                                       {"standard_error", number(record.yield_standard_error)}};
        list.push_back(std::move(json));
    }
    return list;
}

Json loops(const CurveRecord& curve) {
    Json list = Json::array();
    for (const LoopRecord& each : curve.loops)
        list.push_back({{"series", each.series},
                        {"rates_1_s", Json::array({each.loop.low_rate, each.loop.high_rate})},
                        {"area_Pa_s", number(each.loop.measured)},
                        {"inertial_Pa_s", number(each.loop.inertial)},
                        {"rest_Pa_s", number(each.loop.rest())},
                        {"standard_error_Pa_s", number(each.loop.standard_error)}});
    return list;
}

Json ends(const LawRecord& record) {
    Json list = Json::array();
    for (const EndsRecord& each : record.ends)
        list.push_back({{"series", each.series},
                        {"end_factor", Json::array({number(each.least), number(each.most)})},
                        {"conventional", number(each.of_case)},
                        {"relative_error", number(each.relative_error)},
                        {"law", each.stand_in.empty() ? record.result.model : each.stand_in}});
    return list;
}

Json design(const fit::Design& each, const fit::FitResult& result) {
    Json points = Json::array();
    for (const fit::DesignPoint& point : each.points) {
        Json entry = {{"shear_rate_1_s", number(point.rate)}, {"repeats", point.repeats}};
        if (point.speed > 0.0)
            entry["speed"] = number(point.speed);
        points.push_back(std::move(entry));
    }
    Json shrinkage = Json::object();
    for (std::size_t i = 0; i < result.estimates.size(); ++i)
        shrinkage[result.estimates[i].parameter.key] = number(each.shrinkage[i]);
    return {{"geometry", each.name},
            {"rates_1_s", Json::array({number(each.low_rate), number(each.high_rate)})},
            {"points", std::move(points)},
            {"standard_error_ratio", std::move(shrinkage)},
            {"region_volume_ratio", number(each.volume_ratio)}};
}

Json law(const CurveRecord& curve, const LawRecord& record, bool named) {
    const fit::FitResult& result = record.result;
    Json json = Json::object();
    if (named)
        json["curve"] = curve.name;
    json["model"] = result.model;
    json["parameters"] = parameters(result.estimates);
    Json order = Json::array();
    for (const fit::Estimate& estimate : result.estimates)
        order.push_back(estimate.parameter.key);
    json["covariance_order"] = std::move(order);
    json["covariance"] = matrix(result.covariance, result.estimates.size());
    json["correlation"] = matrix(result.correlation, result.estimates.size());
    json["residuals"] = residuals(curve, result);
    json["aicc"] = number(result.criteria.aicc);
    json["bic"] = number(result.criteria.bic);
    json["points_used"] = result.points;
    json["points_excluded"] = curve.data.excluded.size();
    json["degrees_of_freedom"] = result.degrees_of_freedom;
    json["weights"] = fit::name_of(result.weighting);
    json["loss"] = fit::name_of(result.loss);
    json["converged"] = result.converged;
    json["warnings"] = result.warnings;
    if (curve.through_instrument) {
        json["conventional"] = parameters(record.conventional);
        json["ends"] = ends(record);
        json["model_free"] = model_free(curve);
        json["loops"] = loops(curve);
    }
    if (!record.predictions.empty()) {
        Json list = Json::array();
        for (const fit::PredictedPoint& point : record.predictions)
            list.push_back(
                {{"shear_rate_1_s", number(point.rate)},
                 {"shear_stress_Pa", number(point.stress)},
                 {"confidence95",
                  Json::array({number(point.confidence_low), number(point.confidence_high)})},
                 {"prediction95",
                  Json::array({number(point.prediction_low), number(point.prediction_high)})},
                 {"extrapolated", point.extrapolated}});
        json["predictions"] = std::move(list);
    }
    if (!record.designs.empty()) {
        Json list = Json::array();
        for (const fit::Design& each : record.designs)
            list.push_back(design(each, result));
        json["design"] = std::move(list);
    }
    return json;
}

} // namespace

std::string fits_as_json(const std::vector<CurveRecord>& curves, bool as_list) {
    const bool named = curves.size() > 1;
    Json list = Json::array();
    for (const CurveRecord& curve : curves) {
        if (!curve.failure.empty())
            list.push_back({{"curve", curve.name}, {"error", curve.failure}});
        for (const LawRecord& record : curve.laws)
            list.push_back(law(curve, record, named));
    }
    return (as_list || list.size() != 1 ? list : list.front()).dump(2) + "\n";
}

} // namespace searle::app
