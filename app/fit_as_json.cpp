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

Json design(const fit::Design& each, const fit::FitResult& result) {
    Json points = Json::array();
    for (const fit::DesignPoint& point : each.points)
        points.push_back({{"shear_rate_1_s", number(point.rate)}, {"repeats", point.repeats}});
    Json shrinkage = Json::object();
    for (std::size_t i = 0; i < result.estimates.size(); ++i)
        shrinkage[result.estimates[i].parameter.key] = number(each.shrinkage[i]);
    return {{"window", each.window},
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
    if (curve.through_instrument)
        json["conventional"] = parameters(record.conventional);
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
