#include "rheometry/report/colour_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace searle::rheometry::report {

std::string scale_colour(double share) {
    // Every eighth of matplotlib's viridis (S. van der Walt and N. Smith, public domain).
    static constexpr std::array<std::array<double, 3>, 9> stops{{{68, 1, 84},
                                                                 {71, 45, 123},
                                                                 {59, 82, 139},
                                                                 {44, 114, 142},
                                                                 {33, 145, 140},
                                                                 {40, 174, 128},
                                                                 {94, 201, 98},
                                                                 {173, 220, 48},
                                                                 {253, 231, 37}}};
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double rest = at - static_cast<double>(low);
    std::array<int, 3> mixed{};
    for (std::size_t k = 0; k < 3; ++k) {
        mixed[k] =
            static_cast<int>(std::lround((1.0 - rest) * stops[low][k] + rest * stops[low + 1][k]));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

} // namespace searle::rheometry::report
