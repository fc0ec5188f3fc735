#include "rheometry/report/contours.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace searle::rheometry::report {
namespace {

using fields::SectionPoint;

/// A corner of a region: a point of the mesh (both the same), or the cut of the side between two.
using Corner = std::uint64_t;
Corner corner_of(std::uint32_t one, std::uint32_t other) {
    const auto [low, high] = std::minmax(one, other);
    return Corner{low} << 32U | high;
}

struct Step {
    Corner from;
    Corner to;
};

SectionPoint place_of(const DrawnScalar& scalar, Corner corner, double level) {
    const auto a = static_cast<std::size_t>(corner >> 32U);
    const auto b = static_cast<std::size_t>(corner & 0xffffffffU);
    const double share =
        a == b ? 0.0 : (level - scalar.values[a]) / (scalar.values[b] - scalar.values[a]);
    const SectionPoint from = scalar.points[a];
    const SectionPoint to = scalar.points[b];
    return {from.r + share * (to.r - from.r), from.z + share * (to.z - from.z)};
}

/// Joins steps end to end, each used once; open chains first, then closed ones.
std::vector<Polyline> chained(const DrawnScalar& scalar, const std::vector<Step>& steps,
                              double level) {
    std::unordered_multimap<Corner, std::size_t> leaving;
    std::unordered_map<Corner, int> balance;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        leaving.emplace(steps[k].from, k);
        ++balance[steps[k].from];
        --balance[steps[k].to];
    }
    std::vector<Polyline> lines;
    const auto follow = [&](Corner start) {
        Polyline line{place_of(scalar, start, level)};
        Corner at = start;
        for (auto next = leaving.find(at); next != leaving.end(); next = leaving.find(at)) {
            at = steps[next->second].to;
            leaving.erase(next);
            line.push_back(place_of(scalar, at, level));
            if (at == start) {
                break;
            }
        }
        lines.push_back(std::move(line));
    };
    for (const Step& step : steps) {
        if (balance[step.from] > 0 && leaving.contains(step.from)) {
            follow(step.from);
        }
    }
    for (const Step& step : steps) {
        while (leaving.contains(step.from)) {
            follow(step.from);
        }
    }
    return lines;
}

/// The steps around {scalar >= level}: along level lines, and where asked along the border.
std::vector<Step> steps_around(const DrawnScalar& scalar, double level, bool with_border) {
    std::vector<Step> steps;
    for (std::size_t t = 0; t < scalar.triangles.size(); ++t) {
        const auto& corner = scalar.triangles[t];
        std::array<bool, 3> inside{};
        for (std::size_t k = 0; k < 3; ++k) {
            inside[k] = scalar.values[corner[k]] >= level;
        }
        if (!inside[0] && !inside[1] && !inside[2]) {
            continue;
        }
        Corner leaves = 0;
        Corner enters = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const std::uint32_t a = corner[k];
            const std::uint32_t b = corner[next];
            if (inside[k] && !inside[next]) {
                leaves = corner_of(a, b);
            } else if (!inside[k] && inside[next]) {
                enters = corner_of(a, b);
            }
            if (with_border && (scalar.border[t] >> k & 1U) != 0U && (inside[k] || inside[next])) {
                steps.push_back({inside[k] ? corner_of(a, a) : corner_of(a, b),
                                 inside[next] ? corner_of(b, b) : corner_of(a, b)});
            }
        }
        if (leaves != enters) {
            steps.push_back({leaves, enters});
        }
    }
    return steps;
}

} // namespace

DrawnScalar drawn_scalar(const fields::SectionFields& section, std::string_view field) {
    DrawnScalar scalar;
    const fields::NodalField* source = section.find(field);
    if (source == nullptr || source->components != 1) {
        return scalar;
    }
    double size = 0.0;
    for (const SectionPoint& point : section.points) {
        size = std::max({size, std::abs(point.r), std::abs(point.z)});
    }
    const double grain = 1e-9 * size;
    std::map<std::pair<long long, long long>, std::uint32_t> joined;
    std::vector<std::uint32_t> stands_for;
    std::vector<int> count;
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        const SectionPoint& point = section.points[k];
        const auto [place, added] =
            joined.try_emplace({std::llround(point.r / grain), std::llround(point.z / grain)},
                               static_cast<std::uint32_t>(scalar.points.size()));
        if (added) {
            scalar.points.push_back(point);
            scalar.values.push_back(0.0);
            count.push_back(0);
        }
        stands_for.push_back(place->second);
        scalar.values[place->second] += source->values[k];
        ++count[place->second];
    }
    for (std::size_t k = 0; k < count.size(); ++k) {
        scalar.values[k] /= count[k];
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& cell : section.cells) {
        std::array<std::uint32_t, 4> corner{};
        SectionPoint centre;
        double mean = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            corner[k] = stands_for[cell[k]];
            centre.r += 0.25 * scalar.points[corner[k]].r;
            centre.z += 0.25 * scalar.points[corner[k]].z;
            mean += 0.25 * scalar.values[corner[k]];
        }
        if (!std::isfinite(mean)) {
            continue;
        }
        const auto middle = static_cast<std::uint32_t>(scalar.points.size());
        scalar.points.push_back(centre);
        scalar.values.push_back(mean);
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t a = corner[k];
            const std::uint32_t b = corner[(k + 1) % 4];
            scalar.triangles.push_back({a, b, middle});
            ++sides[std::minmax(a, b)];
        }
    }
    for (const auto& corner : scalar.triangles) {
        const SectionPoint& a = scalar.points[corner[0]];
        const SectionPoint& b = scalar.points[corner[1]];
        const SectionPoint& c = scalar.points[corner[2]];
        scalar.area.push_back(0.5 *
                              std::abs((b.r - a.r) * (c.z - a.z) - (b.z - a.z) * (c.r - a.r)));
        // The sides to the centre always have two triangles.
        scalar.border.push_back(sides.at(std::minmax(corner[0], corner[1])) == 1 ? 1U : 0U);
    }
    return scalar;
}

std::vector<Polyline> region_above(const DrawnScalar& scalar, double level) {
    return chained(scalar, steps_around(scalar, level, true), level);
}

std::vector<Polyline> level_lines(const DrawnScalar& scalar, double level) {
    return chained(scalar, steps_around(scalar, level, false), level);
}

double area_quantile(const DrawnScalar& scalar, double share) {
    std::vector<std::size_t> order(scalar.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> mean;
    double total = 0.0;
    for (std::size_t t = 0; t < order.size(); ++t) {
        const auto& corner = scalar.triangles[t];
        mean.push_back(
            (scalar.values[corner[0]] + scalar.values[corner[1]] + scalar.values[corner[2]]) / 3.0);
        total += scalar.area[t];
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t one, std::size_t other) { return mean[one] < mean[other]; });
    double sum = 0.0;
    for (const std::size_t t : order) {
        sum += scalar.area[t];
        if (sum >= share * total) {
            return mean[t];
        }
    }
    return order.empty() ? 0.0 : mean[order.back()];
}

} // namespace searle::rheometry::report
