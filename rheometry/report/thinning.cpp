#include "rheometry/report/thinning.hpp"

#include <cmath>

namespace searle::rheometry::report {

std::vector<std::size_t> thinned_by_distance(std::span<const Pixel> points, std::size_t limit) {
    std::vector<std::size_t> finite;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::isfinite(points[k].x) && std::isfinite(points[k].y)) {
            finite.push_back(k);
        }
    }
    if (finite.size() <= limit) {
        return finite;
    }
    constexpr double growth = 1.3;
    // Scattered data never fall below the limit by distance alone; evenly thinned they do.
    for (double distance = 0.25; distance < 50.0; distance *= growth) {
        std::vector<std::size_t> kept{finite.front()};
        for (const std::size_t k : finite) {
            const Pixel& last = points[kept.back()];
            if (std::hypot(points[k].x - last.x, points[k].y - last.y) >= distance) {
                kept.push_back(k);
                if (kept.size() > limit) {
                    break;
                }
            }
        }
        if (kept.size() > limit) {
            continue;
        }
        if (kept.back() != finite.back()) {
            kept.push_back(finite.back());
        }
        return kept;
    }
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
