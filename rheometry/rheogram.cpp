#include "rheometry/rheogram.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace searle::rheometry {

Rheogram make_rheogram(const TorqueHistory& history, const Conversion& conversion,
                       std::span<const std::string> regimes,
                       std::span<const double> bob_shear_rates) {
    const std::size_t rows = history.rows.size();
    if (regimes.size() != rows)
        throw std::invalid_argument("make_rheogram: one regime per row of the torque history");
    if (!bob_shear_rates.empty() && bob_shear_rates.size() != rows)
        throw std::invalid_argument("make_rheogram: one bob shear rate per row, or none at all");

    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Rheogram rheogram;
    rheogram.points.reserve(rows);
    for (std::size_t i = 0; i < rows; ++i) {
        const TorqueRow& row = history.rows[i];
        const double rate = conversion.shear_rate(row.speed);
        const double stress = conversion.shear_stress(row.torque);
        rheogram.points.push_back(
            {.time = row.time,
             .speed = row.speed,
             .torque = row.torque,
             .shear_rate = rate,
             .shear_stress = stress,
             .viscosity = rate == 0.0 ? unknown : stress / rate,
             .stress_error = std::abs(conversion.shear_stress(row.torque_error)),
             .regime = regimes[i],
             .steady_stress = conversion.shear_stress(row.steady_torque),
             .bob_shear_rate = bob_shear_rates.empty() ? unknown : bob_shear_rates[i],
             .yield_radius = row.yield_radius,
             .suspension = row.suspension});
    }
    return rheogram;
}

} // namespace searle::rheometry
