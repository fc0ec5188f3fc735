#include "app/fit_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::app {
namespace {

std::string interval(const fit::Estimate& estimate) {
    if (estimate.parameter.held)
        return "held";
    if (!std::isfinite(estimate.low) && !std::isfinite(estimate.high))
        return "not determined";
    return fmt::format(
        "{} {:.4g} ... {} {}", estimate.low_open ? "[<=" : "[", estimate.low,
        std::isfinite(estimate.high) ? fmt::format("{:.4g}", estimate.high) : "no limit", "]");
}

std::string about(const EndsRecord& ends) {
    return fmt::format("c_L computed{}: {:.4f} ... {:.4f}; the conventional route takes {:.4g}",
                       ends.stand_in.empty() ? "" : " with the " + ends.stand_in + " law",
                       ends.least, ends.most, ends.of_case);
}

std::string about(const LoopRecord& each) {
    return fmt::format("loop of the ramp, {}, {:.3g} ... {:.3g} 1/s: {:.3g} Pa/s = {:.3g} inertia "
                       "+ {:.3g} +- {:.2g} rest",
                       each.series, each.loop.low_rate, each.loop.high_rate, each.loop.measured,
                       each.loop.inertial, each.loop.rest(), each.loop.standard_error);
}

void add_law(std::string& text, const LawRecord& record) {
    const fit::FitResult& result = record.result;
    text += fmt::format("{}: stress = {}\n", result.model, record.law->formula);
    for (std::size_t i = 0; i < result.estimates.size(); ++i) {
        const fit::Estimate& estimate = result.estimates[i];
        text += fmt::format(
            "  {:<20} {:>11.6g} {:<7} +- {:<10} 95 %: {}{}\n", estimate.parameter.key,
            estimate.value, estimate.parameter.unit == "1" ? "" : estimate.parameter.unit,
            std::isfinite(estimate.standard_error) ? fmt::format("{:.3g}", estimate.standard_error)
                                                   : "-",
            interval(estimate),
            i < record.conventional.size()
                ? fmt::format("   conventional: {:.6g}", record.conventional[i].value)
                : "");
    }
    text += fmt::format(
        "  {} points, {} weights{}; rms deviation {:.3g} %, R^2 {:.6f}, AICc {:.2f}, "
        "BIC {:.2f}",
        result.points, fit::name_of(result.weighting),
        result.loss == fit::Loss::squares ? ""
                                          : fmt::format(", {} loss", fit::name_of(result.loss)),
        100.0 * result.rms_relative, result.determination, result.criteria.aicc,
        result.criteria.bic);
    if (result.runs)
        text += fmt::format("; {} runs of sign ({:.0f} expected, p = {:.2g})", result.runs->runs,
                            result.runs->expected_runs, result.runs->probability);
    text += "\n";
    for (const EndsRecord& ends : record.ends)
        text += fmt::format("  {}\n", about(ends));
    for (const std::string& warning : result.warnings)
        text += fmt::format("  warning: {}\n", warning);
    if (!record.predictions.empty()) {
        text += "    shear rate 1/s   stress Pa   95 % of the curve        95 % of a point\n";
        for (const fit::PredictedPoint& point : record.predictions)
            text += fmt::format(
                "  {:>16.6g} {:>11.5g}   {:>9.5g} ... {:<9.5g}  {:>9.5g} ... {:<9.5g}{}\n",
                point.rate, point.stress, point.confidence_low, point.confidence_high,
                point.prediction_low, point.prediction_high,
                point.extrapolated ? " extrapolated" : "");
    }
    for (const fit::Design& design : record.designs) {
        text += fmt::format("  next points, {} ({:.2g} ... {:.2g} 1/s):", design.name,
                            design.low_rate, design.high_rate);
        for (const fit::DesignPoint& point : design.points)
            text += fmt::format(" {:.3g} 1/s{}", point.rate,
                                point.repeats > 1 ? fmt::format(" (x{})", point.repeats) : "");
        text += "\n    standard errors then, of what they are now:";
        for (std::size_t i = 0; i < design.shrinkage.size(); ++i)
            if (std::isfinite(design.shrinkage[i]))
                text += fmt::format(" {} {:.0f} %", result.estimates[i].parameter.key,
                                    100.0 * design.shrinkage[i]);
        text += "\n";
    }
}

constexpr std::size_t rows_shown = 12;

/// The inversion beside the best law; some of its rows unless all are wanted.
void add_model_free(std::string& text, const ModelFreeRecord& record, bool all_rows) {
    const std::size_t rows = record.rows.size();
    text += fmt::format("  without a law{}: true rate at the rotor, with its 95 % band\n",
                        record.series.empty() ? "" : ", " + record.series);
    text += fmt::format("    {:>10} {:>11}   {:<23} {:>11}  branch\n", "stress Pa", "rate 1/s",
                        "95 %", "by the law");
    const std::size_t shown = all_rows ? rows : std::min(rows, rows_shown);
    for (std::size_t n = 0; n < shown; ++n) {
        const ModelFreeRow& row = record.rows[shown < 2 ? 0 : n * (rows - 1) / (shown - 1)];
        const bool known = std::isfinite(row.rate);
        text += fmt::format("    {:>10.5g} {:>11}   {:<23} {:>11.4g}  {}\n", row.stress,
                            known ? fmt::format("{:.4g}", row.rate) : "-",
                            known ? fmt::format("{:.4g} ... {:.4g}", row.low, row.high)
                                  : "not determined",
                            row.law_rate, name_of(row.branch));
    }
    if (shown < rows)
        text += fmt::format("    ({} of {} rows; --model-free prints all)\n", shown, rows);
    if (record.yield_stress)
        text += fmt::format("    the slow end extrapolates to a yield stress of {:.4g} +- {:.2g} "
                            "Pa\n",
                            *record.yield_stress, record.yield_standard_error);
}

void add_ranking(std::string& text, const CurveRecord& curve) {
    const double best = curve.laws.front().result.criteria.aicc;
    text += "  law                 parameters   AICc    behind      BIC   rms %  R^2\n";
    for (const LawRecord& record : curve.laws) {
        const fit::FitResult& result = record.result;
        text += fmt::format("  {:<18} {:>6} {:>12.2f} {:>8.2f} {:>9.2f} {:>6.2f}  {:.5f}\n",
                            result.model, result.estimates.size(), result.criteria.aicc,
                            result.criteria.aicc - best, result.criteria.bic,
                            100.0 * result.rms_relative, result.determination);
    }
}

/// One line a curve, for many curves and one law.
std::string batch(const std::vector<CurveRecord>& curves) {
    std::size_t width = 5;
    const CurveRecord* first = nullptr;
    for (const CurveRecord& curve : curves) {
        width = std::max(width, curve.name.size());
        if (first == nullptr && !curve.laws.empty())
            first = &curve;
    }
    std::string text;
    if (first != nullptr) {
        text += fmt::format("{:<{}}  points  rms %", "curve", width);
        for (const fit::Estimate& estimate : first->laws.front().result.estimates)
            text += fmt::format("  {:>20}", estimate.parameter.key);
        text += "  warnings\n";
    }
    for (const CurveRecord& curve : curves) {
        if (curve.laws.empty()) {
            text += fmt::format("{:<{}}  {}\n", curve.name, width, curve.failure);
            continue;
        }
        const fit::FitResult& result = curve.laws.front().result;
        text += fmt::format("{:<{}}  {:>6}  {:>5.2f}", curve.name, width, result.points,
                            100.0 * result.rms_relative);
        for (const fit::Estimate& estimate : result.estimates)
            text += fmt::format("  {:>20}", std::isfinite(estimate.standard_error)
                                                ? fmt::format("{:.5g} +- {:.2g}", estimate.value,
                                                              estimate.standard_error)
                                                : fmt::format("{:.5g}", estimate.value));
        text += fmt::format("  {}\n", result.warnings.size());
    }
    return text;
}

} // namespace

std::vector<std::string> notes_on(const CurveRecord& curve) {
    std::vector<std::string> notes;
    if (!curve.laws.empty())
        for (const EndsRecord& ends : curve.laws.front().ends)
            notes.push_back(about(ends) + ".");
    for (const ModelFreeRecord& record : curve.model_free)
        if (record.yield_stress)
            notes.push_back(fmt::format("Without a law the slow end of {} extrapolates to a yield "
                                        "stress of {:.4g} +- {:.2g} Pa.",
                                        record.series, *record.yield_stress,
                                        record.yield_standard_error));
    for (const LoopRecord& each : curve.loops)
        notes.push_back(about(each) + ".");
    return notes;
}

std::string fits_as_text(const std::vector<CurveRecord>& curves, bool all_rows) {
    const bool many = curves.size() > 3 &&
                      std::all_of(curves.begin(), curves.end(),
                                  [](const CurveRecord& curve) { return curve.laws.size() <= 1; });
    if (many && !all_rows)
        return batch(curves);
    std::string text;
    for (const CurveRecord& curve : curves) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", curve.name);
        if (!curve.failure.empty())
            text += fmt::format("  {}\n", curve.failure);
        if (curve.laws.size() > 1)
            add_ranking(text, curve);
        for (const LawRecord& record : curve.laws)
            add_law(text, record);
        for (const ModelFreeRecord& record : curve.model_free)
            if (!curve.laws.empty())
                add_model_free(text, record, all_rows);
        for (const LoopRecord& each : curve.loops)
            text += fmt::format("  {}\n", about(each));
    }
    return text;
}

} // namespace searle::app
