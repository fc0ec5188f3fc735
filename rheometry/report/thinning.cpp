#include "rheometry/report/thinning.hpp"

#include <cmath>

namespace searle::rheometry::report {

namespace {

std::vector<std::size_t> finite_points(std::span<const Pixel> points) {
    std::vector<std::size_t> finite;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::isfinite(points[k].x) && std::isfinite(points[k].y)) {
            finite.push_back(k);
        }
    }
    return finite;
}

// Stops as soon as more than `limit` are kept.
std::vector<std::size_t> spaced(std::span<const Pixel> points,
                                const std::vector<std::size_t>& finite, double distance,
                                std::size_t limit) {
    std::vector<std::size_t> kept;
    for (const std::size_t k : finite) {
        const bool far =
            kept.empty() || std::hypot(points[k].x - points[kept.back()].x,
                                       points[k].y - points[kept.back()].y) >= distance;
        if (far) {
            kept.push_back(k);
        }
        if (kept.size() > limit) {
            return kept;
        }
    }
    if (!finite.empty() && kept.back() != finite.back()) {
        kept.push_back(finite.back());
    }
    return kept;
}

} // namespace

std::vector<std::size_t> spaced_by(std::span<const Pixel> points, double distance) {
    return spaced(points, finite_points(points), distance, points.size());
}

std::vector<std::size_t> thinned_by_distance(std::span<const Pixel> points, std::size_t limit) {
    const std::vector<std::size_t> finite = finite_points(points);
    if (finite.size() <= limit) {
        return finite;
    }
    constexpr double growth = 1.3;
    constexpr double largest_distance = 50.0;
    for (double distance = 0.25; distance < largest_distance; distance *= growth) {
        std::vector<std::size_t> kept = spaced(points, finite, distance, limit);
        if (kept.size() <= limit) {
            return kept;
        }
    }
    // Scattered data never fall below the limit by distance alone; evenly thinned they do.
    std::vector<std::size_t> kept;
    for (const std::size_t k : thinned_evenly(finite.size(), limit)) {
        kept.push_back(finite[k]);
    }
    return kept;
}

std::vector<std::size_t> thinned_evenly(std::size_t count, std::size_t limit) {
    std::vector<std::size_t> kept;
    if (count <= limit) {
        for (std::size_t k = 0; k < count; ++k) {
            kept.push_back(k);
        }
        return kept;
    }
    for (std::size_t k = 0; k < limit; ++k) {
        kept.push_back(k * (count - 1) / (limit - 1));
    }
    return kept;
}

} // namespace searle::rheometry::report
