#include "app/bench/native_run.hpp"

#include "app/solved_case.hpp"
#include "verification/newtonian_start_up.hpp"
#include "verification/precise_gap_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace searle::app::bench {
namespace {

constexpr double pi = std::numbers::pi;

SolvedCase solved(const Case& source) { return solve_case(plan_case(source, StageClock()), {}); }

/// Speeds and times of the rows, without solving more than the plan does.
struct Rows {
    std::vector<double> times, speeds;
};
Rows rows_of(const solvers::Scene& scene) {
    Rows rows;
    for (const solvers::RowForecast& row : solvers::make_plan(scene).rows) {
        rows.times.push_back(row.time);
        rows.speeds.push_back(row.speed);
    }
    return rows;
}

double newtonian_viscosity(const solvers::Scene& scene) {
    return std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
}

/// Exact torques of a ramp from rest in one gap.
std::vector<double> start_up_torques(const solvers::Scene& scene) {
    constexpr int modes = 60;
    const double eta = newtonian_viscosity(scene);
    const double nu = eta / scene.fluid.density;
    const Rows rows = rows_of(scene);
    std::vector<double> torques;
    if (const auto* box = std::get_if<geometry::Box>(&scene.instrument)) {
        const auto exact = verification::NewtonianStartUp::plane(box->gap, nu, modes);
        for (std::size_t k = 0; k < rows.times.size(); ++k)
            torques.push_back(eta * rows.speeds[k] / box->gap * box->length * box->width *
                              exact.viscosity_ratio(rows.times[k]));
        return torques;
    }
    const auto& gap = std::get<geometry::ConcentricCylinders>(scene.instrument);
    const double a = gap.bob_radius;
    const double b = gap.cup_radius;
    const auto exact = verification::NewtonianStartUp::annulus(a, b, nu, modes);
    for (std::size_t k = 0; k < rows.times.size(); ++k)
        torques.push_back(4.0 * pi * eta * rows.speeds[k] * gap.height * a * a * b * b /
                          ((b - a) * (b + a)) * exact.viscosity_ratio(rows.times[k]));
    return torques;
}

/// Both gaps of a double gap in a ramp from rest. Their starts are over at the first row: what is
/// left is exp(-t pi^2 nu / d^2), 1e-24 and less.
std::vector<double> double_gap_torques(const solvers::Scene& scene) {
    const auto& gap = std::get<geometry::DoubleGap>(scene.instrument);
    const double eta = newtonian_viscosity(scene);
    const double nu = eta / scene.fluid.density;
    const auto [r1, r2, r3, r4] = gap.radii;
    const double inside = r1 * r1 * r2 * r2 / ((r2 - r1) * (r2 + r1));
    const double outside = r3 * r3 * r4 * r4 / ((r4 - r3) * (r4 + r3));
    const double inside_lag = verification::annulus_lag(r1, r2, nu, true);
    const double outside_lag = verification::annulus_lag(r3, r4, nu);
    const Rows rows = rows_of(scene);
    std::vector<double> torques;
    for (std::size_t k = 0; k < rows.times.size(); ++k)
        torques.push_back(4.0 * pi * eta * rows.speeds[k] * gap.height *
                          (inside * (1.0 + inside_lag / rows.times[k]) +
                           outside * (1.0 + outside_lag / rows.times[k])));
    return torques;
}

double steady_gap_error(const BenchScene& scene, const std::vector<double>& torques) {
    const Case source = case_of(scene, 1e-3);
    const auto& gap = std::get<geometry::ConcentricCylinders>(source.scene.instrument);
    const std::vector<double> speeds = rows_of(source.scene).speeds;
    const double a = gap.bob_radius;
    const double b = gap.cup_radius;
    double worst = torques.size() == speeds.size() ? 0.0 : unknown;
    for (std::size_t k = 0; k < std::min(speeds.size(), torques.size()); ++k) {
        const double stress = torques[k] / (2.0 * pi * a * a * gap.height);
        worst = std::max(
            worst, std::abs(verification::steady_stress_error(
                       source.scene.fluid.law, (b - a) * (b + a) / (a * a), speeds[k], stress)));
    }
    return worst;
}

} // namespace

Case case_of(const BenchScene& scene, double accuracy) {
    std::vector<Case> cases = read_cases_text(scene.case_text, scene.name + ".toml",
                                              {fmt::format("solver.accuracy={}", accuracy)});
    return cases.front();
}

NativeRun run_native(const Case& source, double least_seconds, double limit,
                     const StopQuestion& stop) {
    const auto work = [&] {
        std::vector<double> seconds;
        double sum = 0.0;
        std::optional<SolvedCase> found;
        while (seconds.size() < 7 && (seconds.empty() || sum < least_seconds)) {
            const double start = process_seconds();
            found = solved(source);
            seconds.push_back(process_seconds() - start);
            sum += seconds.back();
        }
        const auto& rows = found->solution.history.rows;
        std::vector<double> values{found->solution.reached ? 1.0 : 0.0,
                                   static_cast<double>(found->solution.unknowns),
                                   static_cast<double>(seconds.size())};
        values.insert(values.end(), seconds.begin(), seconds.end());
        for (const rheometry::TorqueRow& row : rows) {
            // Of a suspension the scatter of a run as short as this belongs to what it claims.
            const double scatter = row.suspension
                                       ? row.suspension->statistical_error *
                                             std::abs(row.torque / row.suspension->total())
                                       : 0.0;
            for (const double value : {row.time, row.speed, row.torque, row.torque_error + scatter})
                values.push_back(value);
        }
        return values;
    };
    const Ended ended = work_apart(work, limit, stop);
    NativeRun run;
    run.peak_MiB = ended.peak_MiB;
    run.fault = ended.fault;
    if (!run.fault.empty())
        return run;
    const std::vector<double>& v = ended.values;
    run.reached = v[0] != 0.0;
    run.unknowns = v[1] > 0.0 ? v[1] : unknown;
    const auto repeats = static_cast<std::ptrdiff_t>(v[2]);
    run.cpu.assign(v.begin() + 3, v.begin() + 3 + repeats);
    for (std::size_t k = 3 + run.cpu.size(); k + 3 < v.size(); k += 4) {
        run.times.push_back(v[k]);
        run.speeds.push_back(v[k + 1]);
        run.torques.push_back(v[k + 2]);
        run.estimate = std::max(run.estimate, v[k + 3] / std::abs(v[k + 2]));
    }
    return run;
}

Reference reference_for(const BenchScene& scene, double limit, const StopQuestion& stop) {
    Reference reference;
    const Case source = case_of(scene, 1e-3);
    switch (scene.truth) {
    case Truth::start_up_series:
        reference = {start_up_torques(source.scene), 1e-12, "the exact series of the start-up", ""};
        break;
    case Truth::double_gap_ramp:
        reference = {double_gap_torques(source.scene), 1e-12, "both gaps in closed form", ""};
        break;
    case Truth::steady_gap:
        reference = {{}, 1e-15, "an evaluation with 50 digits", ""};
        break;
    case Truth::known_value: {
        const auto& box = std::get<geometry::Box>(source.scene.instrument);
        const double water = newtonian_viscosity(source.scene) * rows_of(source.scene).speeds[0] /
                             box.gap * box.length * box.width;
        reference = {
            {scene.relative_viscosity * water},
            scene.relative_viscosity_error,
            fmt::format("relative viscosity {:.5g} ({})", scene.relative_viscosity, scene.source),
            ""};
        break;
    }
    case Truth::finer_run: {
        const NativeRun finer =
            run_native(case_of(scene, scene.reference_accuracy), 0.0, limit, stop);
        reference = {finer.torques, finer.estimate,
                     fmt::format("its own run at {:.0e}, which claims {:.1e}",
                                 scene.reference_accuracy, finer.estimate),
                     finer.fault};
        break;
    }
    }
    return reference;
}

double true_error(const BenchScene& scene, const Reference& reference,
                  const std::vector<double>& torques) {
    if (scene.truth == Truth::steady_gap)
        return steady_gap_error(scene, torques);
    if (torques.size() != reference.torques.size() || torques.empty())
        return unknown;
    double worst = 0.0;
    for (std::size_t k = 0; k < torques.size(); ++k)
        worst = std::max(worst, std::abs(torques[k] / reference.torques[k] - 1.0));
    return worst;
}

} // namespace searle::app::bench
