#include "app/bench/work_precision.hpp"

#include <algorithm>
#include <cmath>

namespace searle::app::bench {
namespace {

bool is_own(const Measurement& point) { return point.code == "searle"; }

double drawn_error(const SceneResult& scene, const Measurement& point) {
    return std::max(point.true_error, std::max(scene.reference_error, 1e-16));
}

Ratio ratio_of(const SceneResult& scene, const Measurement& peer, WorkAt own) {
    return {.scene = scene.name,
            .code = peer.code,
            .peer = peer.code + ", " + peer.setting,
            .error = peer.true_error,
            .peer_cpu = peer.cpu_median,
            .own_cpu = own.cpu,
            .ratio = peer.cpu_median / own.cpu,
            .at_least = own.beyond};
}

/// Searle's run for a cost: the coarsest accuracy of 1 % or better.
WorkAt own_cost(const SceneResult& scene) {
    const Measurement* chosen = nullptr;
    for (const Measurement& point : scene.points)
        if (is_own(point) && std::isfinite(point.cpu_median) &&
            (chosen == nullptr || chosen->asked > 0.01))
            chosen = &point;
    return {chosen == nullptr ? unknown : chosen->cpu_median, false};
}

} // namespace

std::vector<WorkPoint> best_points(std::vector<WorkPoint> points) {
    std::erase_if(points, [](const WorkPoint& point) {
        return !std::isfinite(point.error) || !std::isfinite(point.cpu) || point.error <= 0.0 ||
               point.cpu <= 0.0;
    });
    // By rising error, so that each point that stays must be cheaper than all before it.
    std::ranges::sort(points, [](const WorkPoint& a, const WorkPoint& b) {
        return a.error != b.error ? a.error < b.error : a.cpu < b.cpu;
    });
    std::vector<WorkPoint> best;
    for (const WorkPoint& point : points)
        if (best.empty() || point.cpu < best.back().cpu)
            best.push_back(point);
    std::ranges::reverse(best);
    return best;
}

WorkAt work_at(const std::vector<WorkPoint>& best, double error) {
    if (best.empty() || !std::isfinite(error) || error < best.back().error)
        return {unknown, false};
    if (error >= best.front().error)
        return {best.front().cpu, error > best.front().error};
    std::size_t k = 0;
    while (best[k + 1].error > error)
        ++k;
    const WorkPoint& coarse = best[k];
    const WorkPoint& fine = best[k + 1];
    const double share = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    return {coarse.cpu * std::pow(fine.cpu / coarse.cpu, share), false};
}

std::vector<Ratio> ratios_of(const BenchResult& result) {
    std::vector<Ratio> ratios;
    for (const SceneResult& scene : result.scenes) {
        std::vector<WorkPoint> own;
        for (const Measurement& point : scene.points)
            if (is_own(point))
                own.push_back({drawn_error(scene, point), point.cpu_median});
        const std::vector<WorkPoint> best = best_points(own);
        for (const Measurement& point : scene.points) {
            if (is_own(point) || !std::isfinite(point.cpu_median))
                continue;
            const WorkAt at = scene.cost_unit.empty() ? work_at(best, drawn_error(scene, point))
                                                      : own_cost(scene);
            if (std::isfinite(at.cpu) &&
                (!scene.cost_unit.empty() || std::isfinite(point.true_error)))
                ratios.push_back(ratio_of(scene, point, at));
        }
    }
    return ratios;
}

std::vector<Ratio> least_ratios(const std::vector<Ratio>& ratios) {
    std::vector<Ratio> least;
    for (const Ratio& ratio : ratios) {
        const auto same = std::ranges::find_if(least, [&](const Ratio& other) {
            return other.scene == ratio.scene && other.code == ratio.code;
        });
        if (same == least.end())
            least.push_back(ratio);
        else if (ratio.ratio < same->ratio)
            *same = ratio;
    }
    return least;
}

double median(std::vector<double> values) {
    if (values.empty())
        return unknown;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace searle::app::bench
