#pragma once

#include "rheometry/report/svg_path.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace searle::rheometry::report {

/// Indices of at most `limit` points (limit >= 2) that trace the same picture: a point is
/// kept when it lies far enough from the one kept before it; the first and the last are always
/// kept. All are kept when there are no more than `limit`. Points that are not finite are left out.
[[nodiscard]] std::vector<std::size_t> thinned_by_distance(std::span<const Pixel> points,
                                                           std::size_t limit);

/// Indices of points that lie at least `distance` pixels from the one kept before; the first and
/// the last are always kept. Points that are not finite are left out.
[[nodiscard]] std::vector<std::size_t> spaced_by(std::span<const Pixel> points, double distance);

/// Indices of at most `limit` (>= 2) of `count` rows, evenly spread, first and last included.
[[nodiscard]] std::vector<std::size_t> thinned_evenly(std::size_t count, std::size_t limit);

} // namespace searle::rheometry::report
