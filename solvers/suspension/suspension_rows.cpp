#include "solvers/suspension/suspension_rows.hpp"

#include "solvers/suspension/block_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace searle::solvers::suspension {
namespace {

using Pick = std::function<double(const StressSample&)>;

std::vector<double> series_of(std::span<const StressSample> samples, const Pick& pick) {
    std::vector<double> series;
    series.reserve(samples.size());
    for (const StressSample& sample : samples)
        series.push_back(pick(sample));
    return series;
}

/// Every column of a row by one estimator of a series.
rheometry::SuspensionStress columns_by(bool walls,
                                       const std::function<double(const Pick&)>& estimate) {
    rheometry::SuspensionStress out;
    const auto part = [&](double StressParts::*member, bool wall) {
        return estimate([=](const StressSample& s) { return (wall ? s.wall : s.bulk).*member; });
    };
    out.fluid = part(&StressParts::fluid, walls);
    out.hydrodynamic = part(&StressParts::hydrodynamic, walls);
    out.contact = part(&StressParts::contact, walls);
    out.dlvo = part(&StressParts::colloid, walls);
    out.brownian = part(&StressParts::brownian, walls);
    out.bulk_fluid = part(&StressParts::fluid, false);
    out.bulk_hydrodynamic = part(&StressParts::hydrodynamic, false);
    out.bulk_contact = part(&StressParts::contact, false);
    out.bulk_dlvo = part(&StressParts::colloid, false);
    out.bulk_brownian = part(&StressParts::brownian, false);
    out.first_normal_difference =
        estimate([](const StressSample& s) { return s.first_normal_difference; });
    out.second_normal_difference =
        estimate([](const StressSample& s) { return s.second_normal_difference; });
    out.particle_pressure = estimate([](const StressSample& s) { return s.particle_pressure; });
    return out;
}

rheometry::TorqueRow finished(const rheometry::SuspensionStress& stress, double time,
                              double wall_area, ClaimedError claimed) {
    rheometry::TorqueRow row;
    row.time = time;
    row.torque = stress.total() * wall_area;
    // The fluid's own part and the isolated stresslets are exact; what the step disturbs are the
    // forces between particles, as the bulk shows them whatever the wall happens to feel.
    const double disturbed =
        std::abs(stress.bulk_contact) + std::abs(stress.bulk_dlvo) + std::abs(stress.bulk_brownian);
    row.torque_error =
        (claimed.forces * disturbed + claimed.films * std::abs(stress.bulk_hydrodynamic) +
         1e-6 * std::abs(stress.total())) *
        wall_area;
    row.suspension = stress;
    return row;
}

double total_of(const StressSample& sample, bool walls) {
    return walls ? sample.wall.total() : sample.bulk.total();
}

} // namespace

double step_scale(double accuracy) { return std::clamp(accuracy / 2e-3, 0.02, 3.0); }

ClaimedError claimed_error(double accuracy, bool films) {
    if (films)
        return {.forces = 1.5 * std::clamp(accuracy, 2e-4, 1e-2),
                .films = 0.15 * std::clamp(accuracy, 2e-4, 1e-2)};
    return {.forces = 2e-3 * step_scale(accuracy), .films = 0.0};
}

rheometry::TorqueRow row_of_hold(std::span<const StressSample> samples, bool walls, double discard,
                                 double wall_area, ClaimedError claimed) {
    std::size_t start = 0;
    if (discard >= 0.0) {
        double strain = 0.0;
        while (start < samples.size() && strain < discard * (1.0 - 1e-9)) {
            strain += std::abs(samples[start].shear_rate) * samples[start].duration;
            ++start;
        }
        start = std::min(start, samples.size() - 1);
    } else {
        start = start_up_length(
            series_of(samples, [&](const StressSample& s) { return total_of(s, walls); }));
    }
    const std::span<const StressSample> kept = samples.subspan(start);
    rheometry::SuspensionStress stress = columns_by(
        walls, [&](const Pick& pick) { return mean_of_series(series_of(kept, pick)).mean; });
    const double error = mean_of_series(series_of(kept, [&](const StressSample& s) {
                             return total_of(s, walls);
                         })).standard_error;
    stress.statistical_error =
        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
    const StressSample& last = samples.back();
    return finished(stress, last.time + 0.5 * last.duration, wall_area, claimed);
}

rheometry::TorqueRow row_of_ramp(std::span<const StressSample> samples, bool walls, double time,
                                 double wall_area, ClaimedError claimed) {
    const std::vector<double> times =
        series_of(samples, [](const StressSample& s) { return s.time; });
    rheometry::SuspensionStress stress = columns_by(walls, [&](const Pick& pick) {
        return line_at(times, series_of(samples, pick), time).value;
    });
    const double error =
        line_at(times,
                series_of(samples, [&](const StressSample& s) { return total_of(s, walls); }), time)
            .standard_error;
    stress.statistical_error =
        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
    return finished(stress, time, wall_area, claimed);
}

} // namespace searle::solvers::suspension
