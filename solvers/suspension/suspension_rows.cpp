#include "solvers/suspension/suspension_rows.hpp"

#include "solvers/suspension/correlated_series.hpp"
#include "solvers/suspension/start_up.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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
    out.contact_number = estimate([](const StressSample& s) { return s.contact_number; });
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

/// Share of a piece's largest rate below which samples do not count for its scatter.
constexpr double slowest_of_piece = 0.1;
/// A statistical error below this share of the stress needs no note.
constexpr double negligible_scatter = 0.01;

void put_scatter(rheometry::SuspensionStress& stress, const SeriesEstimate& estimate) {
    stress.statistical_error =
        std::isfinite(estimate.error) ? estimate.error : std::numeric_limits<double>::quiet_NaN();
    stress.independent_values = estimate.independent;
}

double total_of(const StressSample& sample, bool walls) {
    return walls ? sample.wall.total() : sample.bulk.total();
}

} // namespace

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
    rheometry::SuspensionStress stress =
        columns_by(walls, [&](const Pick& pick) { return plain_mean(series_of(kept, pick)); });
    put_scatter(stress, mean_of_series(series_of(
                            kept, [&](const StressSample& s) { return total_of(s, walls); })));
    const StressSample& last = samples.back();
    return finished(stress, last.time + 0.5 * last.duration, wall_area, claimed);
}

rheometry::TorqueRow row_of_ramp(std::span<const StressSample> samples, bool walls, double time,
                                 double wall_area, ClaimedError claimed) {
    const std::vector<double> times =
        series_of(samples, [](const StressSample& s) { return s.time; });
    rheometry::SuspensionStress stress = columns_by(walls, [&](const Pick& pick) {
        return value_on_line(times, series_of(samples, pick), time);
    });
    put_scatter(
        stress,
        line_at(times,
                series_of(samples, [&](const StressSample& s) { return total_of(s, walls); }),
                time));
    return finished(stress, time, wall_area, claimed);
}

void widen_by_piece(std::span<const StressSample> piece, bool walls, std::size_t samples_per_row,
                    std::span<rheometry::TorqueRow> rows) {
    double fastest = 0.0;
    for (const StressSample& sample : piece)
        fastest = std::max(fastest, std::abs(sample.shear_rate));
    std::vector<double> times;
    std::vector<double> excess;
    for (const StressSample& sample : piece) {
        // Near rest the ratio is noise over next to nothing.
        if (std::abs(sample.shear_rate) < slowest_of_piece * fastest || fastest == 0.0)
            continue;
        const StressParts& bulk = sample.bulk;
        times.push_back(sample.time);
        // Between walls the stresslets follow the fluid's start and are no scatter.
        excess.push_back(
            (bulk.contact + bulk.colloid + bulk.brownian + (walls ? 0.0 : bulk.hydrodynamic)) /
            sample.shear_rate);
    }
    const std::size_t few = 4;
    const std::size_t window = times.size() >= few * samples_per_row ? samples_per_row : 1;
    const std::size_t windows = times.size() / window;
    if (windows < few)
        return;
    double squares = 0.0;
    for (std::size_t k = 0; k < windows; ++k) {
        const double at = plain_mean(std::span(times).subspan(k * window, window));
        const double off = plain_mean(std::span(excess).subspan(k * window, window)) -
                           value_on_line(times, excess, at);
        squares += off * off;
    }
    const double scatter = squares / static_cast<double>(windows - 2);
    for (rheometry::TorqueRow& row : rows) {
        const SeriesEstimate line = line_at(times, excess, row.time);
        if (!std::isfinite(line.error))
            continue;
        // The rate of the row: the fluid's own bulk stress is proportional to it.
        const StressSample& near = *std::ranges::min_element(
            piece, {}, [&](const StressSample& s) { return std::abs(s.time - row.time); });
        const double slow =
            std::abs(near.shear_rate) * std::sqrt(scatter + line.error * line.error);
        double& error = row.suspension->statistical_error;
        if (!(slow <= error))
            row.suspension->independent_values = line.independent;
        error = std::hypot(std::isfinite(error) ? error : 0.0, slow);
    }
}

std::string note_on_scatter(std::span<const rheometry::TorqueRow> rows, double accuracy) {
    std::size_t short_rows = 0;
    std::size_t first = 0;
    std::size_t last = 0;
    double largest = 0.0;
    double fewest = enough_independent;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto& stress = rows[k].suspension;
        if (!stress)
            continue;
        const double share = stress->statistical_error / std::abs(stress->total());
        // NaN, when there are too few samples for any error, is one of them.
        if (share <= std::max(accuracy, negligible_scatter) ||
            stress->independent_values >= enough_independent)
            continue;
        if (short_rows++ == 0)
            first = k + 1;
        last = k + 1;
        largest = std::max(largest, share);
        fewest = std::min(fewest, stress->independent_values);
    }
    if (short_rows == 0)
        return "";
    return fmt::format(
        "{} averaged over so short a time that the stress tells no more than {:.2g} independent "
        "values would ({:.0f} are enough). The statistical error is widened for it, up to {:.2g} % "
        "of the stress; what changes more slowly than that time stays unseen. A longer "
        "hold or ramp, or a larger box, mends it.",
        short_rows == 1 ? fmt::format("Row {} is", first)
                        : fmt::format("{} rows between {} and {} are", short_rows, first, last),
        fewest, enough_independent, 100.0 * largest);
}

} // namespace searle::solvers::suspension
