#include "solvers/fit_instrument/ramp_inertia.hpp"

#include "rheometry/speed_history.hpp"
#include "solvers/radial/rotor_gaps.hpp"
#include "solvers/radial/transient_levels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace searle::solvers::fit_instrument {
namespace {

double widest_gap(const geometry::Instrument& instrument) {
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return gap->gap();
    if (const auto* bob = std::get_if<geometry::DinBob>(&instrument))
        return bob->gap();
    if (const auto* gaps = std::get_if<geometry::DoubleGap>(&instrument))
        return std::max(gaps->inner_gap(), gaps->outer_gap());
    return std::get<geometry::Box>(instrument).gap;
}

/// When the line through the first two rows is at rest, if that is where the run came from.
std::optional<double> rest_before(const TimedRows& rows) {
    const double growth = (rows.speeds[1] - rows.speeds[0]) / (rows.times[1] - rows.times[0]);
    const double start = rows.times[0] - rows.speeds[0] / growth;
    const double spacing = rows.times[1] - rows.times[0];
    // A ramp that starts at time 0 may be read off by a fraction of a row.
    if (std::isfinite(start) && start < rows.times[0] && start >= -0.5 * spacing)
        return start;
    return std::nullopt;
}

rheometry::SpeedHistory history_of(const TimedRows& rows) {
    rheometry::SpeedHistory history;
    const std::optional<double> rest = rest_before(rows);
    // Rows come after the start: a run that was steady has been so for a row's time.
    const double origin = rest.value_or(rows.times[0] - (rows.times[1] - rows.times[0]));
    history.initial_speed = rest ? 0.0 : rows.speeds[0];
    history.pieces.push_back({0.0, rows.times[0] - origin, history.initial_speed, rows.speeds[0]});
    for (std::size_t k = 1; k < rows.times.size(); ++k)
        history.pieces.push_back({rows.times[k - 1] - origin, rows.times[k] - origin,
                                  rows.speeds[k - 1], rows.speeds[k]});
    for (const double time : rows.times)
        history.row_times.push_back(time - origin);
    return history;
}

} // namespace

bool has_history(const TimedRows& rows) {
    return rows.times.size() == rows.speeds.size() && rows.times.size() >= 3 &&
           std::ranges::adjacent_find(rows.times, std::greater_equal{}) == rows.times.end() &&
           std::ranges::all_of(rows.times, [](double time) { return std::isfinite(time); });
}

RampInertia ramp_inertia(const geometry::Instrument& instrument, const laws::flow::AnyFlowLaw& law,
                         double density, const TimedRows& rows, double accuracy) {
    const std::vector<radial::RotorGap> gaps = radial::rotor_gaps(instrument, density);
    const rheometry::SpeedHistory history = history_of(rows);
    const radial::TransientTorque found = radial::solve_levels(gaps, law, history, accuracy, {});
    const std::vector<double> steady = radial::steady_torque(gaps, law, history);
    RampInertia result;
    result.relative_error = found.worst_relative_error;
    result.reached = found.reached && found.torque.size() == rows.times.size();
    for (std::size_t k = 0; k < rows.times.size(); ++k)
        result.torques.push_back(k < found.torque.size() ? found.torque[k] - steady[k] : 0.0);
    return result;
}

double largest_inertia_share(const geometry::Instrument& instrument, double density,
                             const TimedRows& rows, std::span<const double> viscosities) {
    const double gap = widest_gap(instrument);
    double largest = 0.0;
    for (std::size_t k = 0; k + 1 < rows.times.size(); ++k) {
        const double acceleration =
            std::abs(rows.speeds[k + 1] - rows.speeds[k]) / (rows.times[k + 1] - rows.times[k]);
        const double speed = std::max(std::abs(rows.speeds[k]), std::abs(rows.speeds[k + 1]));
        const double viscosity = std::min(viscosities[k], viscosities[k + 1]);
        if (speed > 0.0 && viscosity > 0.0)
            largest =
                std::max(largest, density * gap * gap * acceleration / (3.0 * viscosity * speed));
    }
    return largest;
}

} // namespace searle::solvers::fit_instrument
