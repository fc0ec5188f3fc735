#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace searle::solvers {
namespace {

/// Whether the torque has no kink between a row and the next, but at the row itself.
bool are_joined(const rheometry::SpeedHistory& history, std::size_t row) {
    const double time = history.row_times[row];
    const auto& next = history.piece_at(history.row_times[row + 1]);
    return &history.piece_at(time) == &next ||
           (time == next.start_time && history.speed_at(time) == next.start_speed);
}

} // namespace

double worst_relative_error(std::span<const rheometry::TorqueRow> rows) {
    constexpr double least_share = 1e-3;
    double largest = 0.0;
    for (const rheometry::TorqueRow& row : rows) {
        largest = std::max(largest, std::abs(row.torque));
    }
    double worst = 0.0;
    for (const rheometry::TorqueRow& row : rows) {
        const double scale = std::max(std::abs(row.torque), least_share * largest);
        if (scale > 0.0 && !row.rests) {
            worst = std::max(worst, row.torque_error / scale);
        }
    }
    return worst;
}

std::vector<bool> rows_at_rest(std::span<const double> torque, double yield,
                               const rheometry::SpeedHistory& history) {
    std::vector<bool> rest(torque.size(), false);
    for (std::size_t k = 0; k < torque.size(); ++k) {
        rest[k] = yield > 0.0 && history.speed_at(history.row_times[k]) == 0.0 &&
                  std::abs(torque[k]) <= 1.01 * yield;
    }
    return rest;
}

double error_at_rest(double torque, double yield) { return std::abs(torque) + yield; }

bool turns_within_a_piece(std::span<const double> torque, const rheometry::SpeedHistory& history) {
    for (std::size_t k = 0; k + 1 < torque.size(); ++k) {
        if (torque[k] * torque[k + 1] < 0.0 && are_joined(history, k)) {
            return true;
        }
    }
    return false;
}

std::vector<double> level_changes(std::span<const double> before, std::span<const double> after,
                                  const rheometry::SpeedHistory& history, double tolerance) {
    const std::size_t rows = std::min(before.size(), after.size());
    std::vector<double> change(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t near = k > 0 ? k - 1 : 0; near < std::min(k + 2, rows); ++near) {
            const double of_near = std::abs(after[near] - before[near]);
            // Of a smaller neighbour, as at a stop, the change itself is the measure.
            const double larger = std::max(std::abs(after[near]), std::abs(after[k]));
            const double relative = of_near / std::max(larger, 1e-300);
            change[k] = std::max(change[k], std::min(relative, 1.0) * std::abs(after[k]));
            if (near == k || are_joined(history, std::min(near, k))) {
                change[k] = std::max({change[k], of_near, tolerance * std::abs(after[near])});
            }
        }
    }
    return change;
}

std::vector<double> level_errors(std::span<const double> change, std::span<const double> before) {
    constexpr double safety = 2.0;
    constexpr double safety_of_two = 3.0;
    /// At least this share of a row's last change counts.
    constexpr double least_share = 0.5;
    std::vector<double> error(change.size());
    for (std::size_t k = 0; k < change.size(); ++k) {
        const bool is_third = k < before.size() && before[k] > 0.0;
        const double share =
            is_third ? std::clamp(2.0 * change[k] / before[k], least_share, 1.0) : 1.0;
        error[k] = (is_third ? safety : safety_of_two) * share * change[k];
    }
    return error;
}

} // namespace searle::solvers
