#include "rheometry/fit/fit.hpp"

#include "rheometry/fit/nearby_search.hpp"
#include "rheometry/fit/profile.hpp"
#include "rheometry/fit/weighted_residuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace searle::rheometry::fit {
namespace {

/// Beyond this many points the sum of squares is a parabola as far as the interval reaches, and the
/// standard errors say the same as the profile.
constexpr std::size_t most_profiled_points = 20000;
/// Relative residuals below this are rounding: there is no scatter to make intervals of.
constexpr double rounding = 1e-13;
constexpr SearchEffort first_look{.most_iterations = 20, .relative_decrease = 1e-4};
constexpr SearchEffort next_round{.most_iterations = 20, .relative_decrease = 1e-13};
/// Leaves the last steps, which settle the digits, to the search that does not square the
/// condition.
constexpr SearchEffort way_down{.most_iterations = 200, .relative_decrease = 1e-6};

/// To the last digit; in a valley without a bottom the last digits are left undecided.
Minimum to_the_bottom(const LeastSquaresProblem& problem, std::span<const double> start) {
    Minimum minimum = minimise(problem, start, {.most_iterations = 100});
    if (!minimum.converged)
        minimum = minimise(problem, minimum.parameters, {.relative_decrease = 1e-9});
    return minimum;
}

Minimum best_minimum(const LeastSquaresProblem& problem,
                     const std::vector<std::vector<double>>& starts) {
    Minimum best;
    best.sum_of_squares = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& start : starts) {
        // A first look decides which valley is worth the way to its bottom.
        Minimum found = minimise_nearby(problem, start, first_look);
        if (!std::isfinite(found.sum_of_squares) || found.parameters.empty())
            continue;
        const bool lower = found.sum_of_squares < best.sum_of_squares;
        const bool as_low = found.sum_of_squares <= best.sum_of_squares * (1.0 + 1e-12);
        if (lower || (as_low && found.converged && !best.converged)) {
            const bool settled =
                best.converged && best.sum_of_squares <= found.sum_of_squares * (1.0 + 1e-12);
            best = std::move(found);
            best.converged = best.converged || settled;
        }
    }
    if (std::isfinite(best.sum_of_squares))
        best =
            to_the_bottom(problem, minimise_nearby(problem, best.parameters, way_down).parameters);
    return best;
}

/// Searches again with the weights and the loss that the last optimum implies, until both stand.
void settle_weights(WeightedResiduals& residuals, std::span<const Parameter> parameters,
                    const FitOptions& options, Minimum& minimum) {
    const LeastSquaresProblem problem = residuals.problem(parameters);
    std::vector<double> predicted(residuals.size());
    std::vector<double> plain(residuals.size());
    for (int round = 0; round < 50; ++round) {
        if (options.weighting == Weighting::fitted &&
            residuals.forward().predict(minimum.parameters, predicted, {})) {
            // A prediction near 0 would drown all others.
            const double largest = *std::max_element(predicted.begin(), predicted.end());
            for (double& value : predicted)
                value = std::max(value, 1e-6 * largest);
            residuals.set_reference(predicted);
        }
        if (options.loss != Loss::squares) {
            if (!residuals.plain_residuals(minimum.parameters, plain))
                return;
            const double scale = robust_deviation(plain);
            if (!(scale > rounding))
                return;
            residuals.set_loss(options.loss, scale);
        }
        const std::vector<double> before = minimum.parameters;
        minimum = minimise_nearby(problem, before, next_round);
        double moved = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i)
            moved = std::max(moved, std::abs(minimum.parameters[i] - before[i]) /
                                        std::max(1e-3, std::abs(before[i])));
        if (moved < 1e-9)
            break;
    }
    minimum = to_the_bottom(problem, minimum.parameters);
}

std::vector<bool> free_parameters(const LeastSquaresProblem& problem,
                                  std::span<const double> search) {
    std::vector<bool> is_free(search.size());
    for (std::size_t i = 0; i < search.size(); ++i) {
        const double reach = 1e-9 * (problem.high[i] - problem.low[i]);
        is_free[i] = search[i] > problem.low[i] + std::min(reach, 1e-12) &&
                     search[i] < problem.high[i] - std::min(reach, 1e-12);
    }
    return is_free;
}

/// Curvature at the optimum: inverse normal matrix times the variance of a residual.
std::vector<double> search_covariance(const LeastSquaresProblem& problem, const Minimum& minimum,
                                      const std::vector<bool>& is_free, double variance) {
    const std::size_t count = minimum.parameters.size();
    std::vector<double> residuals(problem.residuals);
    std::vector<double> jacobian(problem.residuals * count);
    if (!problem.evaluate(minimum.parameters, residuals, jacobian))
        return {};
    auto inverse = inverse_normal_matrix(jacobian, count, is_free);
    if (!inverse)
        return {};
    for (double& entry : *inverse)
        entry *= variance;
    return *inverse;
}

double unset() { return std::numeric_limits<double>::quiet_NaN(); }

/// The interval's ends in SI; an end at a bound that is only the search's becomes infinite.
void set_interval(Estimate& estimate, const ProfileInterval& interval) {
    const Parameter& parameter = estimate.parameter;
    estimate.low = from_search(parameter.transform, interval.low);
    estimate.high = from_search(parameter.transform, interval.high);
    estimate.low_open = !interval.low_reached;
    estimate.high_open = !interval.high_reached;
    if (estimate.low_open) {
        if (parameter.low_is_physical)
            estimate.low = parameter.transform == Transform::square_root ? 0.0 : parameter.low;
        else
            estimate.low = parameter.transform == Transform::logarithm
                               ? 0.0
                               : -std::numeric_limits<double>::infinity();
    }
    if (estimate.high_open)
        estimate.high =
            parameter.high_is_physical ? parameter.high : std::numeric_limits<double>::infinity();
}

/// A scale that runs away with another one (a zero viscosity with its time constant) has no end
/// where that one has come to the edge of the search.
void open_at_edges(ProfileInterval& interval, const LeastSquaresProblem& problem,
                   std::span<const Parameter> parameters, std::size_t index) {
    const auto at_edge = [&](std::span<const double> search) {
        for (std::size_t i = 0; i < search.size(); ++i)
            if (i != index && parameters[i].transform == Transform::logarithm &&
                problem.low[i] < problem.high[i] &&
                ((search[i] <= problem.low[i] && !parameters[i].low_is_physical) ||
                 (search[i] >= problem.high[i] && !parameters[i].high_is_physical)))
                return true;
        return false;
    };
    interval.low_reached = interval.low_reached && !at_edge(interval.at_low);
    interval.high_reached = interval.high_reached && !at_edge(interval.at_high);
}

void set_linear_interval(Estimate& estimate, double coordinate, double search_deviation,
                         double quantile) {
    const Parameter& parameter = estimate.parameter;
    const double low = to_search(parameter.transform, parameter.low);
    const double high = to_search(parameter.transform, parameter.high);
    ProfileInterval interval;
    interval.low = std::max(low, coordinate - quantile * search_deviation);
    interval.high = std::min(high, coordinate + quantile * search_deviation);
    interval.low_reached = interval.low > low;
    interval.high_reached = interval.high < high;
    set_interval(estimate, interval);
}

void set_covariances(FitResult& result) {
    const std::size_t count = result.search.size();
    result.covariance.assign(count * count, 0.0);
    result.correlation.assign(count * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        Estimate& estimate = result.estimates[i];
        const double slope = search_slope(estimate.parameter.transform, result.search[i]);
        for (std::size_t k = 0; k < count && !result.search_covariance.empty(); ++k) {
            const double other =
                search_slope(result.estimates[k].parameter.transform, result.search[k]);
            const double entry = result.search_covariance[i * count + k];
            result.covariance[i * count + k] = slope * other * entry;
            const double norm = std::sqrt(result.search_covariance[i * count + i] *
                                          result.search_covariance[k * count + k]);
            result.correlation[i * count + k] = norm > 0.0 ? entry / norm : (i == k ? 1.0 : 0.0);
        }
        const double variance = result.covariance[i * count + i];
        estimate.standard_error = variance > 0.0 ? std::sqrt(variance) : unset();
    }
}

void set_statistics(FitResult& result, const WeightedResiduals& residuals,
                    std::span<const double> observed, std::size_t searched) {
    const auto count = static_cast<double>(observed.size());
    result.fitted.resize(observed.size());
    result.residuals.resize(observed.size());
    (void)residuals.forward().predict(result.search, result.fitted, {});
    (void)residuals.plain_residuals(result.search, result.residuals);
    result.units = residuals.units();
    const double mean = std::accumulate(observed.begin(), observed.end(), 0.0) / count;
    double spread = 0.0;
    double absolute = 0.0;
    double relative = 0.0;
    double log_units = 0.0;
    for (std::size_t k = 0; k < observed.size(); ++k) {
        const double miss = result.fitted[k] - observed[k];
        absolute += miss * miss;
        relative += miss * miss / (observed[k] * observed[k]);
        spread += (observed[k] - mean) * (observed[k] - mean);
        log_units += std::log(std::abs(result.units[k]));
    }
    result.rms_absolute = std::sqrt(absolute / count);
    result.rms_relative = std::sqrt(relative / count);
    // Equal values have no spread but rounding's.
    result.determination = spread > 1e-24 * count * mean * mean ? 1.0 - absolute / spread : unset();
    result.runs = runs_test(result.residuals);
    const double deviance =
        count * std::log(std::max(result.sum_of_squares, count * rounding * rounding) / count) +
        2.0 * log_units;
    result.criteria = information_criteria(deviance, observed.size(), searched);
}

} // namespace

FitResult fit_forward(const ForwardModel& forward, std::span<const double> observed,
                      std::span<const double> deviations, const std::vector<Parameter>& parameters,
                      const std::vector<std::vector<double>>& starts, const FitOptions& options) {
    std::size_t searched = 0;
    for (const Parameter& parameter : parameters)
        searched += parameter.held ? 0 : 1;
    if (observed.size() < searched)
        throw FitError(fmt::format("{} usable point{} cannot determine {} parameters",
                                   observed.size(), observed.size() == 1 ? "" : "s", searched));

    WeightedResiduals residuals(forward, observed, deviations, options.weighting);
    const LeastSquaresProblem problem = residuals.problem(parameters);
    std::vector<std::vector<double>> search_starts;
    for (const std::vector<double>& start : starts) {
        search_starts.emplace_back(start.size());
        for (std::size_t i = 0; i < start.size(); ++i)
            search_starts.back()[i] =
                to_search(parameters[i].transform,
                          std::clamp(start[i], parameters[i].low, parameters[i].high));
    }
    Minimum minimum = best_minimum(problem, search_starts);
    if (!std::isfinite(minimum.sum_of_squares))
        throw FitError("no set of parameters was found for which the law has values at all points");
    if (options.weighting == Weighting::fitted || options.loss != Loss::squares)
        settle_weights(residuals, parameters, options, minimum);

    FitResult result;
    result.points = observed.size();
    result.degrees_of_freedom = observed.size() - searched;
    result.weighting = options.weighting;
    result.loss = options.loss;
    const double quantile = student_t95(result.degrees_of_freedom);
    std::vector<ProfileInterval> intervals;
    double variance = 0.0;
    std::vector<bool> is_free;
    for (int round = 0; round < 5; ++round) {
        variance = result.degrees_of_freedom > 0
                       ? minimum.sum_of_squares / double(result.degrees_of_freedom)
                       : unset();
        is_free = free_parameters(problem, minimum.parameters);
        result.search_covariance = search_covariance(problem, minimum, is_free, variance);
        intervals.clear();
        if (!options.profile_intervals || !(variance > rounding * rounding) ||
            observed.size() > most_profiled_points)
            break;
        std::optional<Minimum> better;
        for (std::size_t i = 0; i < parameters.size() && !better; ++i) {
            intervals.push_back({});
            if (problem.low[i] >= problem.high[i])
                continue;
            intervals.back() =
                profile_interval(problem, minimum, i, variance, quantile,
                                 is_free[i] ? std::span<const double>(result.search_covariance)
                                            : std::span<const double>());
            better = intervals.back().better;
            if (parameters[i].transform == Transform::logarithm)
                open_at_edges(intervals.back(), problem, parameters, i);
        }
        if (!better)
            break;
        intervals.clear();
        minimum = minimise(problem, better->parameters);
    }

    result.search = minimum.parameters;
    result.sum_of_squares = minimum.sum_of_squares;
    result.residual_deviation = std::sqrt(variance);
    result.converged = minimum.converged;
    result.iterations = minimum.iterations;
    const std::size_t count = parameters.size();
    for (std::size_t i = 0; i < count; ++i) {
        Estimate estimate;
        estimate.parameter = parameters[i];
        estimate.value = parameters[i].held
                             ? parameters[i].low
                             : from_search(parameters[i].transform, result.search[i]);
        estimate.at_bound = !is_free[i] && !parameters[i].held;
        if (estimate.at_bound && parameters[i].transform == Transform::square_root &&
            result.search[i] <= problem.low[i] * 1.000001)
            estimate.value = 0.0;
        estimate.low = estimate.high = estimate.value;
        result.estimates.push_back(std::move(estimate));
    }
    set_covariances(result);
    for (std::size_t i = 0; i < count; ++i) {
        Estimate& estimate = result.estimates[i];
        if (parameters[i].held)
            continue;
        const double deviation = result.search_covariance.empty()
                                     ? 0.0
                                     : std::sqrt(result.search_covariance[i * count + i]);
        if (!intervals.empty())
            set_interval(estimate, intervals[i]);
        else if (deviation > 0.0 && std::isfinite(quantile))
            set_linear_interval(estimate, result.search[i], deviation, quantile);
        else if (!(variance <= rounding * rounding))
            set_interval(estimate, {.low = problem.low[i],
                                    .high = problem.high[i],
                                    .low_reached = false,
                                    .high_reached = false,
                                    .at_low = {},
                                    .at_high = {},
                                    .better = {}});
    }
    set_statistics(result, residuals, observed, searched);
    return result;
}

} // namespace searle::rheometry::fit
