#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace searle::solvers {

double worst_relative_error(std::span<const rheometry::TorqueRow> rows) {
    constexpr double least_share = 1e-3;
    double largest = 0.0;
    for (const rheometry::TorqueRow& row : rows) {
        largest = std::max(largest, std::abs(row.torque));
    }
    double worst = 0.0;
    for (const rheometry::TorqueRow& row : rows) {
        const double scale = std::max(std::abs(row.torque), least_share * largest);
        if (scale > 0.0) {
            worst = std::max(worst, row.torque_error / scale);
        }
    }
    return worst;
}

std::vector<double> level_changes(std::span<const double> before, std::span<const double> after) {
    const std::size_t rows = std::min(before.size(), after.size());
    std::vector<double> change(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t near = k > 0 ? k - 1 : 0; near < std::min(k + 2, rows); ++near) {
            const double scale = std::max(std::abs(after[k]), 1e-300);
            const double of_near =
                std::abs(after[near] - before[near]) / std::max(std::abs(after[near]), 1e-300);
            // A neighbour's relative change counts; its absolute one may be of another size.
            change[k] = std::max(change[k], std::min(of_near, 1.0) * scale);
        }
        change[k] = std::max(change[k], std::abs(after[k] - before[k]));
    }
    return change;
}

} // namespace searle::solvers
