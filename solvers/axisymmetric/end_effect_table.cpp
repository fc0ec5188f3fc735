#include "solvers/axisymmetric/end_effect_table.hpp"

#include "rheometry/conversion/conversion.hpp"
#include "solvers/axisymmetric/creeping_swirl.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace searle::solvers::axisymmetric {

EndEffectTable end_effect_table(const Scene& scene, std::span<const double> speeds,
                                const ProgressSink& progress) {
    const SectionShape shape = section_shape(scene.instrument).value();
    const double rate_per_speed =
        rheometry::conversion_for(scene.instrument, scene.conversion).rate_per_speed;
    const bool one_value = std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law) ||
                           std::holds_alternative<laws::flow::PowerLaw>(scene.fluid.law);
    EndEffectTable table;
    CreepingTorque found;
    try {
        for (const double speed : speeds) {
            if (progress) {
                progress(static_cast<double>(table.rows.size()) /
                             static_cast<double>(speeds.size()),
                         "end factors");
            }
            // A Newtonian or power-law fluid has one value.
            if (table.rows.empty() || !one_value) {
                found = creeping_torque(shape, scene.fluid.law, speed,
                                        {.accuracy = scene.solver.accuracy}, progress);
            }
            const double per_torque = found.end_factor / found.torque;
            table.rows.push_back({.speed = speed,
                                  .shear_rate = rate_per_speed * speed,
                                  .end_factor = found.end_factor,
                                  .error = found.error * per_torque,
                                  .lower = found.lower * per_torque,
                                  .upper = found.upper * per_torque});
            table.reached = table.reached && found.reached;
        }
    } catch (const Interrupted&) {
        table.interrupted = true;
    }
    return table;
}

std::vector<double> speeds_for_table(std::span<const double> row_speeds) {
    constexpr std::size_t most = 12;
    constexpr double widest = 1e-3;
    std::set<double> distinct;
    for (const double speed : row_speeds) {
        if (speed != 0.0) {
            distinct.insert(std::abs(speed));
        }
    }
    std::vector<double> speeds(distinct.begin(), distinct.end());
    if (speeds.size() <= most) {
        return speeds;
    }
    const double high = speeds.back();
    const double low = std::max(speeds.front(), widest * high);
    speeds.clear();
    for (std::size_t k = 0; k < most; ++k) {
        speeds.push_back(low * std::pow(high / low, static_cast<double>(k) / (most - 1)));
    }
    return speeds;
}

} // namespace searle::solvers::axisymmetric
