#include "app/fit_record.hpp"

#include "rheometry/tables/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace searle::app {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r;") == std::string::npos)
        return text;
    std::string result = "\"";
    for (const char character : text) {
        if (character == '"')
            result += '"';
        result += character;
    }
    return result + "\"";
}

std::string number(double value) {
    if (std::isnan(value))
        return "nan";
    if (std::isinf(value))
        return value > 0.0 ? "inf" : "-inf";
    return rheometry::number_text(value);
}

} // namespace

std::string fits_as_csv(const std::vector<CurveRecord>& curves) {
    std::string text = "curve,model,parameter,value,unit,standard_error,ci95_low,ci95_high,points,"
                       "rms_relative,r_squared,aicc,bic,conventional,warnings\n";
    for (const CurveRecord& curve : curves)
        for (const LawRecord& record : curve.laws) {
            std::string warnings;
            for (const std::string& warning : record.result.warnings)
                warnings += (warnings.empty() ? "" : " | ") + warning;
            for (std::size_t i = 0; i < record.result.estimates.size(); ++i) {
                const fit::Estimate& estimate = record.result.estimates[i];
                text += fmt::format(
                    "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(curve.name),
                    record.result.model, estimate.parameter.key, number(estimate.value),
                    estimate.parameter.unit, number(estimate.standard_error), number(estimate.low),
                    number(estimate.high), record.result.points, number(record.result.rms_relative),
                    number(record.result.determination), number(record.result.criteria.aicc),
                    number(record.result.criteria.bic),
                    i < record.conventional.size() ? number(record.conventional[i].value) : "",
                    quoted(warnings));
            }
        }
    return text;
}

std::string model_free_as_csv(const std::vector<CurveRecord>& curves) {
    std::string text = "series,line,angular_velocity_rad_s,rotor_stress_Pa,rotor_rate_1_s,"
                       "ci95_low_1_s,ci95_high_1_s,branch,law_rate_1_s\n";
    for (const CurveRecord& curve : curves)
        for (const ModelFreeRecord& record : curve.model_free)
            for (const ModelFreeRow& row : record.rows)
                text += fmt::format("{},{},{},{},{},{},{},{},{}\n", quoted(record.series), row.line,
                                    number(row.speed), number(row.stress), number(row.rate),
                                    number(row.low), number(row.high), name_of(row.branch),
                                    number(row.law_rate));
    return text;
}

std::string predictions_as_csv(const std::vector<CurveRecord>& curves) {
    std::string text = "curve,model,shear_rate_1_s,shear_stress_Pa,confidence95_low_Pa,"
                       "confidence95_high_Pa,prediction95_low_Pa,prediction95_high_Pa,"
                       "extrapolated\n";
    for (const CurveRecord& curve : curves)
        for (const LawRecord& record : curve.laws)
            for (const fit::PredictedPoint& point : record.predictions)
                text += fmt::format("{},{},{},{},{},{},{},{},{}\n", quoted(curve.name),
                                    record.result.model, number(point.rate), number(point.stress),
                                    number(point.confidence_low), number(point.confidence_high),
                                    number(point.prediction_low), number(point.prediction_high),
                                    point.extrapolated ? "yes" : "no");
    return text;
}

} // namespace searle::app
