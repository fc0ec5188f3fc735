#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>

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

} // namespace searle::solvers
