#include "rheometry/correction/wall_rate.hpp"

#include "rheometry/correction/flow_curve.hpp"
#include "rheometry/correction/gap_inversion.hpp"
#include "rheometry/correction/local_slope.hpp"
#include "rheometry/correction/plug_flow_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace searle::rheometry {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_points = 5;
/// Of ln(speed), for a slope to mean anything.
constexpr double narrowest_range = 0.4;
/// The yield stress is fitted to points whose stress is at most this many times the stress where
/// the fluid at the cup starts to move if the slowest point is just at the yield stress.
constexpr double fit_range = 3.0;
constexpr std::size_t fewest_fitted = 8;
/// Share of the smallest stress that a yield stress must reach to be told from none.
constexpr double least_yield_share = 0.02;
/// Points that a law is fitted to; neighbours are merged beyond.
constexpr std::size_t most_fitted = 60;
/// A law that misses the curve by more than this, root mean square of ln(stress), guides nothing.
constexpr double guide_residual = 0.05;
/// Share of a correction that is taken as its own uncertainty.
constexpr double fraction_left_out = 0.5;
/// Standard errors between a stress and the yield stress that make a branch certain.
constexpr double certain = 2.0;

struct Estimate {
    double rate = not_known;
    double standard_error = not_known;
};

struct Slope {
    double value{};  ///< N = d ln omega / d ln tau
    double change{}; ///< dN / d ln tau
};

/// A Herschel-Bulkley law in this gap, fitted to the whole curve (a Newtonian one where none fits):
/// what the local fits and the inversion start from. They are left with the ratio of the data to
/// it, which is nearly flat, so that wide windows do not blur it and the terms that the inversion
/// leaves out nearly cancel.
struct GuidePoint {
    double log_stress{};
    Slope slope{};
    double rate{}; ///< at the bob, 1/s
    bool sheared{};
};

std::vector<GuidePoint> guide_along(const FlowCurve& curve, double delta) {
    const FlowCurve few = thinned(curve, most_fitted);
    const auto fit = fit_plug_flow(few.omega(), few.stress(), few.weights, delta);
    const bool follows = fit && fit->residual < guide_residual;
    const PlugFlowLaw law = follows ? fit->law : PlugFlowLaw{0.0, 1.0, 1.0};
    std::vector<GuidePoint> guide(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double omega = std::exp(curve.log_omega[i]);
        const double stress = bob_stress(law, omega, delta);
        const double at_cup = stress / (delta * delta);
        const double slope = (law.rate(stress) - law.rate(at_cup)) / (2.0 * omega);
        const double bend =
            (stress * law.rate_slope(stress) - at_cup * law.rate_slope(at_cup)) / (2.0 * omega);
        guide[i] = {.log_stress = std::log(stress),
                    .slope = {slope, bend - slope * slope},
                    .rate = law.rate(stress),
                    .sheared = law.rate(at_cup) > 0.0};
    }
    return guide;
}

/// One point of the merged curve with its slope, and the guide's there.
struct SlopedPoint {
    double omega{};
    double stress{};
    Slope slope{};
    Slope standard_error{};
    GuidePoint guide{};

    [[nodiscard]] bool is_known() const { return std::isfinite(slope.value); }
};

std::vector<SlopedPoint> sloped_points(const FlowCurve& curve, double delta) {
    const std::vector<GuidePoint> guide = guide_along(curve, delta);
    std::vector<double> rest(curve.size());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = curve.log_stress[i] - guide[i].log_stress;
    const std::vector<LocalSlope> local = local_slopes(curve.log_omega, rest, curve.weights);
    std::vector<SlopedPoint> points(local.size());
    for (std::size_t i = 0; i < local.size(); ++i) {
        // The speed is what the drive imposes, so that stress is fitted over speed, and N is the
        // inverse of the fitted slope.
        const auto cubed = [](double value) { return value * value * value; };
        const double slope = 1.0 / guide[i].slope.value + local[i].slope;
        const double curvature =
            local[i].curvature - guide[i].slope.change / cubed(guide[i].slope.value);
        const bool resolved = slope > certain * local[i].slope_standard_error;
        const double inverse = resolved ? 1.0 / slope : not_known;
        points[i] = {.omega = std::exp(curve.log_omega[i]),
                     .stress = std::exp(guide[i].log_stress + local[i].value),
                     .slope = {inverse, -curvature * cubed(inverse)},
                     .standard_error = {inverse * inverse * local[i].slope_standard_error,
                                        local[i].curvature_standard_error * cubed(inverse)},
                     .guide = guide[i]};
    }
    return points;
}

Estimate partly_sheared(const SlopedPoint& point) {
    return {partly_sheared_bob_rate(point.omega, point.slope.value),
            partly_sheared_bob_rate(point.omega, point.standard_error.value)};
}

/// Krieger's rate times what it is wrong by for the guide. What is still left out is taken as a
/// share of that factor, and of how far the second terms of data and guide differ.
Estimate fully_sheared(const SlopedPoint& point, double delta) {
    const double omega = point.omega;
    const double leading = power_law_bob_rate(omega, point.slope.value, delta);
    const double second =
        slope_change_correction(omega, point.slope.value, point.slope.change, delta);
    double rate = leading + second;
    double left_out = fraction_left_out * second;
    if (point.guide.sheared) {
        const Slope& guide = point.guide.slope;
        const double guide_leading = power_law_bob_rate(omega, guide.value, delta);
        const double guide_second =
            slope_change_correction(omega, guide.value, guide.change, delta);
        const double scale = point.guide.rate / (guide_leading + guide_second);
        rate *= scale;
        left_out = fraction_left_out * leading *
                   std::hypot(second / leading - guide_second / guide_leading, scale - 1.0);
    }
    const double from_slope =
        power_law_bob_rate(omega, point.slope.value + point.standard_error.value, delta) - leading;
    const double from_change =
        slope_change_correction(omega, point.slope.value, point.standard_error.change, delta);
    return {rate, std::hypot(from_slope, from_change, left_out)};
}

struct Yield {
    PlugFlowFit fit;
    bool stands_out{};
};

std::optional<Yield> yield_of(const FlowCurve& curve, double delta) {
    const double limit = curve.log_stress.front() + std::log(fit_range) + 2.0 * std::log(delta);
    const auto end =
        std::ranges::find_if(curve.log_stress, [limit](double value) { return value > limit; });
    const auto reached = static_cast<std::size_t>(end - curve.log_stress.begin());
    const std::size_t count = std::min(curve.size(), std::max(reached, fewest_fitted));
    const FlowCurve slow_end = thinned(first_points(curve, count), most_fitted);
    const auto fit = fit_plug_flow(slow_end.omega(), slow_end.stress(), slow_end.weights, delta);
    if (!fit)
        return std::nullopt;
    const PlugFlowLaw& law = fit->law;
    const double least = std::max(certain * fit->yield_standard_error,
                                  least_yield_share * slow_end.stress().front());
    return Yield{*fit, law.yield_stress > least};
}

GapBranch branch_at(double stress, const std::optional<Yield>& yield, double delta) {
    if (!yield)
        return GapBranch::unknown;
    const double at_cup = stress / (delta * delta);
    const double doubt = certain * yield->fit.yield_standard_error;
    if (at_cup > yield->fit.law.yield_stress + doubt)
        return GapBranch::sheared;
    return at_cup < yield->fit.law.yield_stress - doubt ? GapBranch::partly_sheared
                                                        : GapBranch::unknown;
}

/// The straight line through two points, or the cubic through four, in the logarithms.
double interpolated(const std::vector<SlopedPoint>& points, const std::vector<Estimate>& done,
                    std::size_t first, std::size_t last, double stress) {
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
        double share = std::log(done[i].rate);
        for (std::size_t k = first; k <= last; ++k)
            if (k != i)
                share *= std::log(stress / points[k].stress) /
                         std::log(points[i].stress / points[k].stress);
        sum += share;
    }
    return std::exp(sum);
}

/// The rate at a stress among the first `count` points, which are done; no value outside of them.
Estimate rate_at(const std::vector<SlopedPoint>& points, const std::vector<Estimate>& done,
                 std::size_t count, double stress) {
    for (std::size_t i = count; i-- > 1;) {
        if (!(points[i - 1].stress <= stress && stress < points[i].stress))
            continue;
        const std::size_t first = std::min(i > 1 ? i - 2 : 0, count >= 4 ? count - 4 : 0);
        const std::size_t last = std::min(first + 3, count - 1);
        for (std::size_t k = first; k <= last; ++k)
            if (!(done[k].rate > 0.0) || (k > first && points[k].stress <= points[k - 1].stress))
                return {};
        const double straight = interpolated(points, done, i - 1, i, stress);
        const double cubic = interpolated(points, done, first, last, stress);
        return {cubic, std::abs(cubic - straight) +
                           std::max(done[i - 1].standard_error, done[i].standard_error)};
    }
    return {};
}

/// The exact step from the cup to the bob, with the rate at the cup from the points done before, or
/// from the fitted law between the yield stress and the first point. Neighbouring slopes err the
/// same way, so that their errors add.
Estimate stepped(const std::vector<SlopedPoint>& points, const std::vector<Estimate>& done,
                 std::size_t index, const std::optional<Yield>& yield, double delta) {
    const double at_cup = points[index].stress / (delta * delta);
    Estimate below = rate_at(points, done, index, at_cup);
    if (yield && yield->stands_out && at_cup < points.front().stress) {
        const double rate = yield->fit.law.rate(at_cup);
        below = {rate, 0.5 * rate + 0.1 * yield->fit.law.rate(points.front().stress)};
    }
    const Estimate difference = partly_sheared(points[index]);
    return {difference.rate + below.rate, difference.standard_error + below.standard_error};
}

/// The one with the smaller standard error, where there is a second one.
Estimate more_certain(const Estimate& first, const Estimate& second) {
    return second.standard_error < first.standard_error ? second : first;
}

Estimate covering(const Estimate& first, const Estimate& second) {
    return {0.5 * (first.rate + second.rate),
            std::hypot(0.5 * (first.rate - second.rate),
                       std::max(first.standard_error, second.standard_error))};
}

} // namespace

std::string_view name_of(GapBranch branch) {
    switch (branch) {
    case GapBranch::sheared:
        return "sheared";
    case GapBranch::partly_sheared:
        return "partly-sheared";
    case GapBranch::unknown:
        return "unknown";
    }
    return {};
}

WallRates no_rates(std::size_t rows) {
    WallRates result;
    result.rows.assign(rows, {not_known, not_known, GapBranch::unknown});
    return result;
}

WallRates wall_rates(std::span<const double> speeds, std::span<const double> bob_stresses,
                     double delta) {
    if (bob_stresses.size() != speeds.size())
        throw std::invalid_argument("wall_rates: as many stresses as speeds");
    if (!(delta > 1.0))
        throw std::invalid_argument("wall_rates: the ratio of the radii must be above 1");
    WallRates result = no_rates(speeds.size());
    const FlowCurve curve = merged_curve(speeds, bob_stresses);
    if (curve.size() < fewest_points ||
        curve.log_omega.back() - curve.log_omega.front() < narrowest_range)
        return result;

    const std::vector<SlopedPoint> points = sloped_points(curve, delta);
    const std::optional<Yield> yield = yield_of(curve, delta);
    if (yield && yield->stands_out) {
        result.yield_stress = yield->fit.law.yield_stress;
        result.yield_standard_error = yield->fit.yield_standard_error;
    }
    std::vector<Estimate> estimates(points.size());
    std::vector<GapBranch> branches(points.size(), GapBranch::unknown);
    for (std::size_t i = 0; i < points.size(); ++i) {
        branches[i] = branch_at(points[i].stress, yield, delta);
        if (!points[i].is_known())
            continue;
        const Estimate plugged = partly_sheared(points[i]);
        const Estimate sheared = more_certain(fully_sheared(points[i], delta),
                                              stepped(points, estimates, i, yield, delta));
        estimates[i] = branches[i] == GapBranch::sheared          ? sheared
                       : branches[i] == GapBranch::partly_sheared ? plugged
                                                                  : covering(plugged, sheared);
    }
    for (std::size_t row = 0; row < speeds.size(); ++row) {
        const std::optional<CurvePosition> at = curve.position_of(speeds[row], bob_stresses[row]);
        if (!at)
            continue;
        const Estimate& low = estimates[at->index];
        const Estimate& high = estimates[at->index + (at->share > 0.0 ? 1 : 0)];
        const double rate =
            at->share > 0.0
                ? std::exp(std::lerp(std::log(low.rate), std::log(high.rate), at->share))
                : low.rate;
        result.rows[row] = {std::copysign(rate, speeds[row]),
                            std::lerp(low.standard_error, high.standard_error, at->share),
                            branches[at->share < 0.5 ? at->index : at->index + 1]};
    }
    return result;
}

} // namespace searle::rheometry
