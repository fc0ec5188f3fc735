#include "rheometry/fit/fit.hpp"

#include "rheometry/fit/starting_values.hpp"
#include "rheometry/fit/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace searle::rheometry::fit {
namespace {

std::size_t searched_parameters(std::span<const Parameter> parameters) {
    return static_cast<std::size_t>(
        std::count_if(parameters.begin(), parameters.end(),
                      [](const Parameter& parameter) { return !parameter.held; }));
}

double middle_rate(const FlowData& data) {
    return std::sqrt(data.rates.front() * data.rates.back());
}

/// Fits laws to one data set, each simpler law once.
class CurveFits {
public:
    CurveFits(const FlowData& data, const FitOptions& options)
        : data_(data), options_(options), scale_(scale_of(data.rates, data.stresses)) {}

    FitResult fit(const Model& model) {
        const std::vector<Parameter> parameters = bounded_parameters(model, scale_, options_);
        if (data_.size() < searched_parameters(parameters))
            throw FitError(fmt::format("{}: {} usable point{} cannot determine {} parameters",
                                       model.name, data_.size(), data_.size() == 1 ? "" : "s",
                                       searched_parameters(parameters)));
        FitResult result = fit_with(model, parameters, starts_for(model), options_);
        if (!within_definition(model, result.values()) && !contained_in(model).empty())
            result = simplest_form(model, parameters);
        add_warnings(result, model, data_);
        return result;
    }

private:
    FitResult fit_with(const Model& model, const std::vector<Parameter>& parameters,
                       const std::vector<std::vector<double>>& starts, const FitOptions& options) {
        const FlowCurveModel forward(model, data_.rates);
        FitResult result =
            fit_forward(forward, data_.stresses, data_.deviations, parameters, starts, options);
        result.model = model.name;
        result.present_rates = data_.rates;
        return result;
    }

    std::vector<std::vector<double>> starts_for(const Model& model) {
        std::vector<std::vector<double>> starts =
            starting_values(model, data_.rates, data_.stresses);
        for (const std::string_view name : contained_in(model)) {
            const Model& simpler = *model_named(name);
            if (simpler.size() < model.size() && data_.size() >= simpler.size())
                starts.push_back(embedded(simpler, values_of(simpler), model, middle_rate(data_)));
        }
        return starts;
    }

    /// Best values of a simpler law, without intervals.
    const std::vector<double>& values_of(const Model& simpler) {
        const auto known = simpler_.find(simpler.name);
        if (known != simpler_.end())
            return known->second;
        FitOptions quick = options_;
        quick.profile_intervals = false;
        quick.bounds.clear();
        const std::vector<Parameter> parameters = parameters_for(simpler, scale_);
        std::vector<std::vector<double>> starts =
            starting_values(simpler, data_.rates, data_.stresses);
        if (simpler.name != "newtonian" && !contained_in(simpler).empty()) {
            const Model& simplest = *model_named("newtonian");
            starts.push_back(embedded(simplest, values_of(simplest), simpler, middle_rate(data_)));
        }
        return simpler_[simpler.name] = fit_with(simpler, parameters, starts, quick).values();
    }

    /// The law at the edge of its definition, where it is one of those that it contains.
    FitResult simplest_form(const Model& model, const std::vector<Parameter>& parameters) {
        const Model& simpler = *model_named(contained_in(model).back());
        const std::vector<double> values =
            embedded(simpler, values_of(simpler), model, middle_rate(data_));
        std::vector<Parameter> held = parameters;
        FitOptions quick = options_;
        quick.profile_intervals = false;
        const std::vector<Parameter>& shown = simpler.parameters;
        for (std::size_t i = 0; i < held.size(); ++i) {
            const bool kept = std::any_of(shown.begin(), shown.end(), [&](const Parameter& other) {
                return other.key == held[i].key;
            });
            if (!kept) {
                held[i].low = held[i].high = values[i];
                held[i].held = true;
            }
        }
        FitResult result = fit_with(model, held, {values}, quick);
        result.warnings.push_back(fmt::format(
            "the data pull {} out of its definition; it is given as the {} law that it contains, "
            "and the parameters without a standard error are not determined",
            model.name, simpler.name));
        // Ranked by the parameters that it has, not by those left to it here.
        const double left = double(searched_parameters(held)) + 1.0;
        result.criteria =
            information_criteria(result.criteria.bic - left * std::log(double(result.points)),
                                 result.points, searched_parameters(parameters));
        return result;
    }

    const FlowData& data_;
    const FitOptions& options_;
    DataScale scale_;
    std::map<std::string_view, std::vector<double>> simpler_;
};

void check_usable(const FlowData& data, const FitOptions& options) {
    if (data.size() == 0)
        throw FitError(data.excluded.empty()
                           ? std::string("there are no points")
                           : fmt::format("none of the {} points can be used; the first: {}",
                                         data.excluded.size(), data.excluded.front().reason));
    if (options.weighting == Weighting::custom && data.deviations.empty())
        throw FitError("custom weights need a column of standard deviations");
}

} // namespace

std::vector<Parameter> bounded_parameters(const Model& model, const DataScale& scale,
                                          const FitOptions& options, bool ignore_unknown) {
    std::vector<Parameter> parameters = parameters_for(model, scale);
    for (const auto& [key, range] : options.bounds) {
        const auto index = model.find(key);
        if (!index) {
            if (ignore_unknown)
                continue;
            std::string known;
            for (const Parameter& parameter : model.parameters)
                known += (known.empty() ? "" : ", ") + parameter.key;
            throw FitError(
                fmt::format("{} has no parameter '{}'; it has {}", model.name, key, known));
        }
        Parameter& parameter = parameters[*index];
        if (!(range.low <= range.high))
            throw FitError(fmt::format("{}: the lower bound {} is above the upper bound {}", key,
                                       range.low, range.high));
        const bool below =
            parameter.transform == Transform::logarithm ? !(range.low > 0.0) : range.low < 0.0;
        if (below || (parameter.low_is_physical && range.low < parameter.low && range.low != 0.0))
            throw FitError(fmt::format("{}: {} is below the least value {:g} of {}", key, range.low,
                                       parameter.low_is_physical ? parameter.low : 0.0,
                                       model.name));
        parameter.low = std::max(
            range.low, parameter.transform == Transform::square_root ? parameter.low : range.low);
        parameter.high = std::max(range.high, parameter.low);
        parameter.held = range.low == range.high;
        parameter.low_is_physical = true;
        parameter.high_is_physical = true;
    }
    return parameters;
}

FitResult fit_flow_curve(const Model& model, const FlowData& data, const FitOptions& options) {
    check_usable(data, options);
    return CurveFits(data, options).fit(model);
}

std::vector<FitResult> fit_all(std::span<const Model> laws, const FlowData& data,
                               const FitOptions& options) {
    check_usable(data, options);
    FitOptions each = options;
    std::vector<FitResult> results;
    for (const Model& model : laws) {
        // A bound goes to the laws that have the parameter.
        each.bounds.clear();
        for (const auto& [key, range] : options.bounds)
            if (model.find(key))
                each.bounds[key] = range;
        if (data.size() >= model.size())
            results.push_back(CurveFits(data, each).fit(model));
    }
    if (results.empty())
        throw FitError(fmt::format("{} usable point{} cannot determine any law", data.size(),
                                   data.size() == 1 ? "" : "s"));
    std::stable_sort(results.begin(), results.end(), [](const FitResult& a, const FitResult& b) {
        if (std::isfinite(a.criteria.aicc) || std::isfinite(b.criteria.aicc))
            return a.criteria.aicc < b.criteria.aicc;
        return a.sum_of_squares < b.sum_of_squares;
    });
    return results;
}

} // namespace searle::rheometry::fit
