#include "solvers/radial/level_differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace searle::solvers::radial {
namespace {

std::vector<bool> follows_smoothly(const rheometry::SpeedHistory& history) {
    std::vector<bool> smooth(history.row_times.size(), true);
    double speed = history.initial_speed;
    for (const auto& piece : history.pieces) {
        if (piece.start_speed != speed) {
            const auto first = std::upper_bound(history.row_times.begin(), history.row_times.end(),
                                                piece.start_time);
            if (first != history.row_times.end()) {
                smooth[static_cast<std::size_t>(first - history.row_times.begin())] = false;
            }
        }
        speed = piece.end_speed;
    }
    return smooth;
}

} // namespace

RowLinks row_links(const rheometry::SpeedHistory& history, bool newtonian) {
    RowLinks links{.smooth = follows_smoothly(history), .stops = {}};
    for (const double time : history.row_times) {
        links.stops.push_back(!newtonian && history.speed_at(time) == 0.0);
    }
    return links;
}

std::vector<double> level_differences(std::span<const double> fine, std::span<const double> coarse,
                                      std::span<const double> scale, const RowLinks& links,
                                      const std::vector<bool>& rests) {
    const std::size_t rows = std::min(fine.size(), coarse.size());
    std::vector<double> plain(rows, 0.0);
    for (std::size_t k = 0; k < rows; ++k) {
        if (scale[k] > 0.0 && !rests[k]) {
            plain[k] = std::abs(fine[k] - coarse[k]) / scale[k];
        }
    }
    // Where the torque passes through zero a neighbour's difference is larger than its share of the
    // row's own scale says; half of it counts.
    constexpr double absolute_share = 0.5;
    std::vector<double> widened = plain;
    const auto widen = [&](std::size_t row, std::size_t neighbour) {
        if (links.stops[neighbour] && !links.stops[row]) {
            return;
        }
        const double absolute =
            scale[row] > 0.0 && fine[row] * fine[neighbour] < 0.0
                ? absolute_share * plain[neighbour] * scale[neighbour] / scale[row]
                : 0.0;
        widened[row] = std::max({widened[row], plain[neighbour], absolute});
    };
    for (std::size_t k = 1; k < rows; ++k) {
        if (links.smooth[k]) {
            widen(k, k - 1);
            widen(k - 1, k);
        }
    }
    return widened;
}

} // namespace searle::solvers::radial
