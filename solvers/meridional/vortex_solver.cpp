#include "solvers/meridional/vortex_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/meridional/steady_vortices.hpp"
#include "solvers/meridional/vortex_run.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "solvers/row_errors.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace searle::solvers::meridional {
namespace {

/// Past this multiple of the onset experiments see vortices that are no longer axisymmetric.
constexpr double wavy_ratio = 1.1;
/// Vortices that add less than this share of the torque do not show.
constexpr double shown = 1e-3;
/// Share of the onset below which the cell's flow is not looked at.
constexpr double near_onset = 0.9;
/// What waves may change, as a share of what the vortices add.
constexpr double wavy_share = 0.1;

struct VortexGap {
    radial::AnnularGap gap;
    double height{};
};

VortexGap gap_outside_rotor(const geometry::Instrument& instrument) {
    if (const auto* cylinders = std::get_if<geometry::ConcentricCylinders>(&instrument)) {
        return {{cylinders->bob_radius, cylinders->cup_radius}, cylinders->height};
    }
    const auto& gaps = std::get<geometry::DoubleGap>(instrument);
    return {{gaps.radii[2], gaps.radii[3]}, gaps.height};
}

double wavelength_for(const Scene& scene, const radial::AnnularGap& gap) {
    const double relative = gap.width() / gap.inner_radius;
    return scene.solver.vortex_wavelength.value_or(
        2.0 * std::numbers::pi * gap.width() / stability::taylor_threshold(relative).wave_number);
}

void add_steady_vortices(const Scene& scene, const Plan& plan, const VortexGap& outside,
                         double wavelength, radial::RadialReport& report,
                         const ProgressSink& progress) {
    SteadyVortices vortices(outside.gap, wavelength, scene.fluid.law, scene.fluid.density,
                            0.5 * scene.solver.accuracy);
    std::vector<rheometry::TorqueRow>& rows = report.history.rows;
    // By rising speed, so that each flow starts from the one before.
    std::map<double, InertiaFactor> factors;
    for (const RowForecast& row : plan.rows) {
        if (row.taylor_ratio > 1.0) {
            factors[std::abs(row.speed)] = {};
        }
    }
    for (auto& [speed, factor] : factors) {
        factor = vortices.at(speed, progress);
        report.refinements = std::max(report.refinements, factor.levels);
        report.unknowns = std::max(report.unknowns, factor.unknowns);
    }
    report.linear_solves += vortices.factorisations();
    for (rheometry::TorqueRow& row : rows) {
        const auto found = factors.find(std::abs(row.speed));
        if (found == factors.end()) {
            continue;
        }
        const double laminar =
            outside.height *
            radial::steady_gap_flow(outside.gap, scene.fluid.law, found->first).torque_per_length;
        row.torque += std::copysign((found->second.factor - 1.0) * laminar, row.speed);
        row.torque_error += found->second.relative_error * found->second.factor * laminar;
    }
}

void add_growing_vortices(const Scene& scene, const Plan& plan,
                          const rheometry::SpeedHistory& history, const VortexGap& outside,
                          double wavelength, radial::RadialReport& report,
                          const ProgressSink& progress) {
    const VortexRun run =
        vortex_run(outside.gap, wavelength, scene.fluid.law, scene.fluid.density,
                   scene.solver.disturbance, history, scene.solver.accuracy, progress);
    // The cell's flow takes the place of the laminar one in the gap outside the rotor, shortly
    // before the first row past the onset; until then that one is known better.
    const std::vector<radial::RotorGap> gaps =
        radial::rotor_gaps(scene.instrument, scene.fluid.density);
    const radial::TransientTorque laminar = radial::solve_levels(
        {&gaps.back(), 1}, scene.fluid.law, history, scene.solver.accuracy, progress);
    std::vector<rheometry::TorqueRow>& rows = report.history.rows;
    rows.resize(std::min({rows.size(), run.torque.size(), laminar.torque.size()}));
    bool is_past = false;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        is_past = is_past || plan.rows[k].taylor_ratio > near_onset;
        if (is_past) {
            rows[k].torque += outside.height * run.torque[k] - laminar.torque[k];
            rows[k].torque_error += outside.height * run.error[k];
        }
    }
    report.transient = true;
    report.refinements = std::max(report.refinements, run.levels);
    report.elements = std::max(report.elements, run.elements);
    report.unknowns = std::max(report.unknowns, run.unknowns);
    report.time_steps += run.time_steps;
    report.linear_solves += run.linear_solves;
    report.notes.push_back(
        fmt::format("The vortices grow from a rotor speed that is uneven by {:.3g} along the axis "
                    "(solver.disturbance): with less they show later.",
                    scene.solver.disturbance));
}

/// What lies beyond axisymmetric vortices.
void doubt_waves(const Scene& scene, const Plan& plan, const radial::RadialReport& laminar,
                 radial::RadialReport& report) {
    const bool is_free_choice = scene.solver.model == Model::automatic;
    std::size_t count = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < report.history.rows.size(); ++k) {
        if (plan.rows[k].taylor_ratio <= wavy_ratio) {
            continue;
        }
        ++count;
        most = std::max(most, plan.rows[k].taylor_ratio);
        if (is_free_choice) {
            report.history.rows[k].torque_error +=
                wavy_share *
                std::abs(report.history.rows[k].torque - laminar.history.rows[k].torque);
        }
    }
    if (count > 0) {
        report.notes.push_back(fmt::format(
            "{} row{} past {:.2g} times the onset (up to {:.3g}): experiments see wavy, later "
            "turbulent vortices there, which are not axisymmetric{}.",
            count, count == 1 ? " lies" : "s lie", wavy_ratio, most,
            is_free_choice ? "; a tenth of what the vortices add is in the error. model = "
                             "\"axisymmetric\" asks for axisymmetric vortices"
                           : ""));
    }
}

/// Where vortices could be and none are: a wavelength that does not grow, or not yet.
void note_missing_vortices(const Plan& plan, const radial::RadialReport& laminar,
                           radial::RadialReport& report) {
    std::size_t past = 0;
    std::size_t missing = 0;
    for (std::size_t k = 0; k < report.history.rows.size(); ++k) {
        if (plan.rows[k].taylor_ratio > 1.0) {
            ++past;
            const double flat = laminar.history.rows[k].torque;
            missing += std::abs(report.history.rows[k].torque - flat) < shown * std::abs(flat);
        }
    }
    if (missing > 0) {
        report.notes.push_back(fmt::format(
            "At {} of the {} rows past the onset no vortices show (less than {:.1g} % of "
            "the torque): those of this wavelength do not grow there, or have not yet.",
            missing, past, 100.0 * shown));
    }
}

} // namespace

radial::RadialReport solve_with_vortices(const Scene& scene, const Plan& plan,
                                         const ProgressSink& progress) {
    radial::RadialReport report = radial::solve_radial(scene, plan, progress);
    if (report.interrupted) {
        return report;
    }
    const radial::RadialReport laminar = report;
    const VortexGap outside = gap_outside_rotor(scene.instrument);
    const double wavelength = wavelength_for(scene, outside.gap);
    report.notes.push_back(fmt::format("Taylor vortices of the axial wavelength {:.4g} mm ({:.4g} "
                                       "gap widths).",
                                       1e3 * wavelength, wavelength / outside.gap.width()));
    const auto schedule = rheometry::schedule(
        scene.protocol, rheometry::conversion_for(scene.instrument, scene.conversion));
    try {
        if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule)) {
            add_growing_vortices(scene, plan, *history, outside, wavelength, report, progress);
        } else {
            add_steady_vortices(scene, plan, outside, wavelength, report, progress);
        }
    } catch (const Interrupted&) {
        // Laminar rows past the onset would be wrong; the ones before it are right.
        std::size_t before = 0;
        while (before < report.history.rows.size() && plan.rows[before].taylor_ratio <= 1.0) {
            ++before;
        }
        report.history.rows.resize(before);
        report.interrupted = true;
        report.reached = false;
        return report;
    }
    doubt_waves(scene, plan, laminar, report);
    note_missing_vortices(plan, laminar, report);
    if (!report.fields.empty()) {
        report.notes.emplace_back(
            "The fields and their pictures show the laminar flow without the vortices.");
    }
    report.worst_relative_error = worst_relative_error(report.history.rows);
    report.reached = report.worst_relative_error <= scene.solver.accuracy;
    return report;
}

} // namespace searle::solvers::meridional
