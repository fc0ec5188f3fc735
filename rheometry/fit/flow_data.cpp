#include "rheometry/fit/flow_data.hpp"

#include "rheometry/disturbed_regime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace searle::rheometry::fit {
namespace {

/// Why a point says nothing about a flow law; empty: it does.
std::string reason_to_leave_out(const MeasuredPoint& point, const Selection& selection,
                                bool keep_disturbed) {
    if (!std::isfinite(point.rate))
        return "the shear rate is missing";
    if (!std::isfinite(point.stress))
        return "the shear stress is missing";
    if (point.rate == 0.0)
        return "at rest: the shear rate is 0";
    if (point.stress == 0.0)
        return "the shear stress is 0";
    if (std::signbit(point.rate) != std::signbit(point.stress))
        return "the shear stress has not the sign of the shear rate";
    const double rate = std::abs(point.rate);
    // Beyond these, sums of squares leave the range of double precision.
    const auto is_beyond = [](double size) { return size < 1e-100 || size > 1e100; };
    if (is_beyond(rate) || is_beyond(std::abs(point.stress)))
        return "beyond 1e-100 ... 1e100, where no measurement is: is the unit right?";
    if (selection.rates && (rate < selection.rates->low || rate > selection.rates->high))
        return "outside the range of shear rates asked for";
    if (!keep_disturbed)
        if (const std::string_view regime = disturbance_in(point.regime); !regime.empty())
            return fmt::format("regime {}: the torque is not that of the flow law alone", regime);
    return "";
}

void add_remarks(FlowData& data) {
    if (data.size() < 2)
        return;
    std::size_t repeated = 0;
    std::size_t falling = 0;
    for (std::size_t k = 1; k < data.size(); ++k) {
        repeated += data.rates[k] == data.rates[k - 1] ? 1 : 0;
        falling +=
            data.rates[k] > data.rates[k - 1] && data.stresses[k] < 0.98 * data.stresses[k - 1] ? 1
                                                                                                : 0;
    }
    if (repeated > 0)
        data.remarks.push_back(fmt::format(
            "{} of {} points repeat a shear rate; each counts by itself", repeated, data.size()));
    if (falling > 0)
        data.remarks.push_back(fmt::format(
            "the stress falls by more than 2 % with rising rate at {} of {} steps: scatter, "
            "wall slip, shear banding or a history of the sample; no flow law falls",
            falling, data.size() - 1));
    for (std::size_t k = 1; k < data.size(); ++k)
        if (data.rates[k] > 9.0 * data.rates[k - 1])
            data.remarks.push_back(fmt::format("no point between {:.4g} and {:.4g} 1/s",
                                               data.rates[k - 1], data.rates[k]));
    if (data.rates.back() < 10.0 * data.rates.front())
        data.remarks.push_back(fmt::format(
            "the rates cover {:.2g} decades ({:.4g} to {:.4g} 1/s): little to tell laws apart by",
            std::log10(data.rates.back() / data.rates.front()), data.rates.front(),
            data.rates.back()));
    if (data.stresses.back() == data.stresses.front() &&
        std::all_of(data.stresses.begin(), data.stresses.end(),
                    [&](double stress) { return stress == data.stresses.front(); }))
        data.remarks.push_back("all stresses are equal: the curve has a level and nothing else; a "
                               "sensor at its limit shows this too");
}

/// With fewer points than this in the regimes that a conversion is made for, all are kept.
constexpr std::size_t fewest_undisturbed = 5;

FlowData selected(std::span<const MeasuredPoint> points, const Selection& selection,
                  bool keep_disturbed) {
    FlowData data;
    std::vector<std::size_t> order;
    const bool has_deviations =
        std::any_of(points.begin(), points.end(), [](const MeasuredPoint& point) {
            return std::isfinite(point.deviation) && point.deviation > 0.0;
        });
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::string reason = reason_to_leave_out(points[k], selection, keep_disturbed);
        if (reason.empty() && has_deviations && !(points[k].deviation > 0.0))
            reason = "the standard deviation is missing or not above 0";
        if (reason.empty())
            order.push_back(k);
        else
            data.excluded.push_back({points[k], std::move(reason)});
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(points[a].rate) < std::abs(points[b].rate);
    });
    for (const std::size_t k : order) {
        data.rates.push_back(std::abs(points[k].rate));
        data.stresses.push_back(std::abs(points[k].stress));
        data.lines.push_back(points[k].line);
        if (has_deviations)
            data.deviations.push_back(points[k].deviation);
    }
    add_remarks(data);
    return data;
}

} // namespace

FlowData select_points(std::span<const MeasuredPoint> points, const Selection& selection) {
    FlowData data = selected(points, selection, selection.keep_disturbed);
    if (selection.keep_disturbed || data.size() >= fewest_undisturbed)
        return data;
    FlowData all = selected(points, selection, true);
    if (all.size() == data.size())
        return data;
    all.remarks.push_back(fmt::format(
        "{} of {} points carry lag, vortices or end flow; they are kept, since only {} others are "
        "there, and pull the parameters",
        all.size() - data.size(), all.size(), data.size()));
    return all;
}

} // namespace searle::rheometry::fit
