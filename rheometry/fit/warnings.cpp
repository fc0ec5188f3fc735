#include "rheometry/fit/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::rheometry::fit {
namespace {

bool is_open(const Estimate& estimate) {
    return !estimate.parameter.held && (estimate.low_open || estimate.high_open);
}

void warn_of_bounds(FitResult& result) {
    for (const Estimate& estimate : result.estimates) {
        const Parameter& parameter = estimate.parameter;
        if (!estimate.at_bound)
            continue;
        if (parameter.key == "yield_stress" && estimate.value == 0.0)
            result.warnings.push_back(fmt::format(
                "yield_stress is 0: these data show none (it may reach {:.3g} Pa)", estimate.high));
        else
            result.warnings.push_back(
                fmt::format("{} lies on its bound, {:.6g}{}", parameter.key, estimate.value,
                            parameter.unit == "1" ? "" : " " + parameter.unit));
    }
}

void warn_of_open_intervals(FitResult& result) {
    for (const Estimate& estimate : result.estimates) {
        const Parameter& parameter = estimate.parameter;
        if (!is_open(estimate) || estimate.at_bound || result.degrees_of_freedom == 0)
            continue;
        if (parameter.key == "yield_stress" && estimate.low_open) {
            result.warnings.push_back(
                "yield_stress is not identifiable from this range: 0 is within "
                "its 95 % interval; points at lower rates would tell");
        } else if (estimate.low_open && estimate.high_open) {
            result.warnings.push_back(
                fmt::format("{} is not determined by these data", parameter.key));
        } else if (estimate.high_open) {
            result.warnings.push_back(fmt::format(
                "{} has no upper limit within what these data can tell", parameter.key));
        } else {
            result.warnings.push_back(fmt::format(
                "{} has no lower limit within what these data can tell", parameter.key));
        }
    }
}

void warn_of_correlation(FitResult& result) {
    const std::size_t count = result.estimates.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = i + 1; k < count; ++k) {
            const double correlation = result.correlation[i * count + k];
            if (std::abs(correlation) >= 0.99)
                result.warnings.push_back(fmt::format(
                    "{} and {} are correlated {:.4f}: only a combination of them is determined",
                    result.estimates[i].parameter.key, result.estimates[k].parameter.key,
                    correlation));
        }
}

/// 2 scatter^2 is the relative bias of weights taken from scattered values; it matters once it is
/// comparable with the standard error, scatter / sqrt(points).
void warn_of_biased_weights(FitResult& result) {
    const double scatter = result.residual_deviation;
    if (result.weighting == Weighting::relative && std::isfinite(scatter) &&
        2.0 * scatter * std::sqrt(double(result.points)) > 0.3)
        result.warnings.push_back(fmt::format(
            "the scatter of {:.2g} % pulls a fit with relative weights down by about {:.1g} %; "
            "--weights fitted does not have this bias",
            100.0 * scatter, 200.0 * scatter * scatter));
}

} // namespace

void add_parameter_warnings(FitResult& result) {
    if (!result.converged)
        result.warnings.push_back("the search ran out of steps; the numbers are its last state");
    if (result.degrees_of_freedom == 0)
        result.warnings.push_back("as many parameters as points: the law goes through all of them, "
                                  "and nothing is known about the uncertainty");
    warn_of_bounds(result);
    warn_of_open_intervals(result);
    warn_of_correlation(result);
    const bool patterned = result.runs && result.runs->probability < 0.01;
    if (patterned)
        result.warnings.push_back(fmt::format(
            "the residuals follow a pattern ({} runs of equal sign, {:.0f} expected, p = {:.1g}): "
            "the law does not describe this curve, and the intervals are too narrow",
            result.runs->runs, result.runs->expected_runs, result.runs->probability));
    else
        warn_of_biased_weights(result);
}

void add_warnings(FitResult& result, const Model& model, const FlowData& data) {
    std::vector<std::string> own = std::move(result.warnings);
    result.warnings = data.remarks;
    result.warnings.insert(result.warnings.end(), own.begin(), own.end());
    const double yield = model.yield_stress(result.values());
    add_parameter_warnings(result);
    if (yield > 0.0 && data.stresses.front() > 3.0 * yield)
        result.warnings.push_back(fmt::format(
            "yield_stress {:.3g} Pa is extrapolated: the lowest stress measured is {:.3g} Pa",
            yield, data.stresses.front()));
}

} // namespace searle::rheometry::fit
