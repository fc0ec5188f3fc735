#include "solvers/meridional/vortex_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/meridional/steady_vortices.hpp"
#include "solvers/meridional/vortex_fields.hpp"
#include "solvers/meridional/vortex_run.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "solvers/row_errors.hpp"
#include "solvers/stability/vortex_torque.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace searle::solvers::meridional {
namespace {

/// Past this multiple of the onset experiments see vortices that are no longer axisymmetric.
constexpr double wavy_ratio = 1.1;
/// Vortices that add less than this share of the torque do not show.
constexpr double shown = 1e-3;
/// Share of the onset below which the cell's flow is not looked at.
constexpr double near_onset = 0.9;
/// Below the onset again, vortices that add no more than this many times the cell's own error are
/// taken for gone: the laminar flow is known better, and the bar holds both.
constexpr double indistinct = 3.0;
/// What waves may change, as a share of what the vortices add.
constexpr double wavy_share = 0.1;
/// Share of that doubt which the vortices are solved to: no more can be had of them.
constexpr double worthwhile = 0.1;
/// Of the accuracy; the laminar flow and waves share the rest.
constexpr double vortex_share = 0.5;
/// Past about this multiple of the onset the flow is chaotic (11.7 in Fenstermacher, Swinney &
/// Gollub 1979, J. Fluid Mech. 94, 103), later turbulent: nothing axisymmetric resembles it.
constexpr double turbulent_ratio = 10.0;
/// Of a torque taken from what was measured in turbulent flow: of a Newtonian fluid, of others.
constexpr double newtonian_doubt = 0.2;
constexpr double other_doubt = 0.5;

struct VortexGap {
    radial::AnnularGap gap;
    double height{};

    [[nodiscard]] double relative_width() const { return gap.width() / gap.inner_radius; }
};

VortexGap gap_outside_rotor(const geometry::Instrument& instrument) {
    if (const auto* cylinders = std::get_if<geometry::ConcentricCylinders>(&instrument)) {
        return {{cylinders->bob_radius, cylinders->cup_radius}, cylinders->height};
    }
    const auto& gaps = std::get<geometry::DoubleGap>(instrument);
    return {{gaps.radii[2], gaps.radii[3]}, gaps.height};
}

double wavelength_for(const Scene& scene, const Plan& plan, const VortexGap& outside) {
    return scene.solver.vortex_wavelength.value_or(2.0 * std::numbers::pi * outside.gap.width() /
                                                   plan.taylor.value().wave_number);
}

bool is_free_choice(const Scene& scene) { return scene.solver.model == Model::automatic; }

bool is_turbulent(const Scene& scene, const RowForecast& row) {
    return is_free_choice(scene) && row.taylor_ratio > turbulent_ratio;
}

/// What is worth asking of axisymmetric vortices where waves may change what they add.
double worthwhile_accuracy(const Scene& scene, const RowForecast& row) {
    const double asked = scene.solver.accuracy;
    if (!is_free_choice(scene) || row.taylor_ratio <= wavy_ratio) {
        return asked;
    }
    const double added = 1.0 - 1.0 / std::sqrt(row.taylor_ratio);
    return std::max(asked, worthwhile * wavy_share * added);
}

double laminar_torque(const Scene& scene, const VortexGap& outside, double speed) {
    return outside.height *
           radial::steady_gap_flow(outside.gap, scene.fluid.law, speed).torque_per_length;
}

double turbulence_doubt(const Scene& scene) {
    return is_newtonian(scene) ? newtonian_doubt : other_doubt;
}

/// Adds what turbulence was measured to add, and the doubt of it.
void add_turbulence(const Scene& scene, const VortexGap& outside, const RowForecast& forecast,
                    rheometry::TorqueRow& row) {
    const double ratio =
        stability::vortex_torque_ratio(outside.relative_width(), forecast.taylor_ratio);
    const double laminar = laminar_torque(scene, outside, std::abs(row.speed));
    row.torque += std::copysign((ratio - 1.0) * laminar, row.speed);
    row.torque_error += turbulence_doubt(scene) * ratio * laminar;
}

void add_steady_vortices(const Scene& scene, const Plan& plan, const VortexGap& outside,
                         double wavelength, radial::RadialReport& report,
                         const ProgressSink& progress) {
    SteadyVortices vortices(outside.gap, wavelength, scene.fluid.law, scene.fluid.density);
    std::vector<rheometry::TorqueRow>& rows = report.history.rows;
    // By rising speed, so that each flow starts from the one before.
    std::map<double, double> accuracies;
    for (const RowForecast& row : plan.rows) {
        if (row.taylor_ratio > 1.0 && !is_turbulent(scene, row)) {
            accuracies[std::abs(row.speed)] = worthwhile_accuracy(scene, row);
        }
    }
    std::map<double, InertiaFactor> factors;
    for (const auto& [speed, accuracy] : accuracies) {
        const InertiaFactor& factor = factors[speed] =
            vortices.at(speed, vortex_share * accuracy, progress);
        if (vortices.flow() != nullptr) {
            show_steady_vortex(outside.gap, scene.fluid.law, speed, *vortices.flow(),
                               report.fields);
        }
        report.refinements = std::max(report.refinements, factor.levels);
        report.unknowns = std::max(report.unknowns, factor.unknowns);
    }
    report.linear_solves += vortices.factorisations();
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rheometry::TorqueRow& row = rows[k];
        if (is_turbulent(scene, plan.rows[k])) {
            add_turbulence(scene, outside, plan.rows[k], row);
        }
        const auto found = factors.find(std::abs(row.speed));
        if (found == factors.end()) {
            continue;
        }
        const double laminar = laminar_torque(scene, outside, found->first);
        row.torque += std::copysign((found->second.factor - 1.0) * laminar, row.speed);
        row.torque_error += found->second.relative_error * found->second.factor * laminar;
    }
}

/// The history up to its row number `count`, >= 1.
rheometry::SpeedHistory first_rows(const rheometry::SpeedHistory& history, std::size_t count) {
    rheometry::SpeedHistory part = history;
    if (count >= part.row_times.size()) {
        return part;
    }
    part.row_times.resize(count);
    const double end = part.row_times.back();
    std::erase_if(part.pieces, [end](const auto& piece) { return piece.start_time >= end; });
    rheometry::SpeedHistory::Piece& last = part.pieces.back();
    last.end_speed = history.speed_at(end);
    last.end_time = end;
    return part;
}

void add_growing_vortices(const Scene& scene, const Plan& plan,
                          const rheometry::SpeedHistory& history, const VortexGap& outside,
                          double wavelength, radial::RadialReport& report,
                          const ProgressSink& progress) {
    std::vector<rheometry::TorqueRow>& rows = report.history.rows;
    // Up to the first turbulent row; from there on nothing is followed.
    const std::size_t followed = static_cast<std::size_t>(
        std::ranges::find_if(plan.rows,
                             [&](const RowForecast& row) { return is_turbulent(scene, row); }) -
        plan.rows.begin());
    std::vector<double> accuracies;
    for (std::size_t k = 0; k < followed; ++k) {
        accuracies.push_back(vortex_share * worthwhile_accuracy(scene, plan.rows[k]));
    }
    VortexRun run;
    radial::TransientTorque laminar;
    if (followed > 0) {
        run =
            vortex_run(outside.gap, wavelength, scene.fluid.law, scene.fluid.density,
                       scene.solver.disturbance, first_rows(history, followed), accuracies,
                       radial::rows_with_fields(scene.output, history.row_times.size()), progress);
        // The cell's flow takes the place of the laminar one in the gap outside the rotor, shortly
        // before the first row past the onset; until then that one is known better.
        const std::vector<radial::RotorGap> gaps =
            radial::rotor_gaps(scene.instrument, scene.fluid.density);
        laminar = radial::solve_levels({&gaps.back(), 1}, scene.fluid.law, history,
                                       scene.solver.accuracy, progress);
        rows.resize(std::min(rows.size(), laminar.torque.size()));
    }
    if (run.torque.size() < followed) { // stuck
        rows.resize(std::min(rows.size(), run.torque.size()));
    }
    for (std::size_t k = followed; k < rows.size(); ++k) {
        add_turbulence(scene, outside, plan.rows[k], rows[k]);
    }
    bool is_near = false;
    std::optional<std::size_t> first_past;
    for (std::size_t k = 0; k < std::min(followed, rows.size()); ++k) {
        is_near = is_near || plan.rows[k].taylor_ratio > near_onset;
        if (!first_past && plan.rows[k].taylor_ratio > 1.0) {
            first_past = k;
        }
        if (is_near) {
            const double added = outside.height * run.torque[k] - laminar.torque[k];
            const double error = outside.height * run.error[k];
            const bool are_gone = first_past && plan.rows[k].taylor_ratio < 1.0 &&
                                  std::abs(added) <= indistinct * error;
            if (!are_gone) {
                rows[k].torque += added;
            }
            rows[k].torque_error += error;
            // An even rotor has no vortices yet: the uneven one's are of no instrument.
            if (!first_past || are_gone) {
                rows[k].torque_error += std::abs(added);
            }
        }
    }
    for (rheometry::fields::SectionFields& vortex : run.fields) {
        if (first_past && vortex.row > *first_past) {
            show_vortex(std::move(vortex), report.fields);
        }
    }
    report.transient = true;
    report.refinements = std::max(report.refinements, run.levels);
    report.elements = std::max(report.elements, run.elements);
    report.unknowns = std::max(report.unknowns, run.unknowns);
    report.time_steps += run.time_steps;
    report.linear_solves += run.linear_solves;
    report.interrupted = run.interrupted;
    if (!run.stopped.empty()) {
        report.notes.push_back(run.stopped);
    }
    report.notes.push_back(
        fmt::format("The vortices grow from a rotor speed that is uneven by {:.3g} along the axis "
                    "(solver.disturbance): with less they show later.",
                    scene.solver.disturbance));
}

/// What lies beyond axisymmetric vortices.
void doubt_waves(const Scene& scene, const Plan& plan, const radial::RadialReport& laminar,
                 radial::RadialReport& report) {
    std::size_t count = 0;
    std::size_t turbulent = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < report.history.rows.size(); ++k) {
        if (plan.rows[k].taylor_ratio <= wavy_ratio) {
            continue;
        }
        ++count;
        most = std::max(most, plan.rows[k].taylor_ratio);
        if (is_turbulent(scene, plan.rows[k])) {
            ++turbulent;
        } else if (is_free_choice(scene)) {
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
            is_free_choice(scene) ? "; a tenth of what the vortices add is in the error. model = "
                                    "\"axisymmetric\" asks for axisymmetric vortices"
                                  : ""));
    }
    if (turbulent > 0) {
        report.notes.push_back(fmt::format(
            "At {} of them, past {:.3g} times the onset, the torque is not solved for: it is what "
            "was measured in turbulent flow of Newtonian fluids (Wendt 1933), within {:.2g} %.",
            turbulent, turbulent_ratio, 100.0 * turbulence_doubt(scene)));
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
    const double wavelength = wavelength_for(scene, plan, outside);
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
        drop_fields_without_rows(report.history.rows.size(), report.fields);
        report.interrupted = true;
        report.reached = false;
        return report;
    }
    doubt_waves(scene, plan, laminar, report);
    note_missing_vortices(plan, laminar, report);
    drop_fields_without_rows(report.history.rows.size(), report.fields);
    if (std::ranges::any_of(report.fields, shows_vortex)) {
        report.notes.emplace_back(
            "Fields and pictures of rows with vortices show one of them, half a wavelength of the "
            "gap outside the rotor.");
    }
    report.worst_relative_error = worst_relative_error(report.history.rows);
    report.reached = !report.interrupted && report.worst_relative_error <= scene.solver.accuracy;
    return report;
}

void doubt_vortices_left_out(const Scene& scene, const Plan& plan, radial::RadialReport& report) {
    if (!is_endless_gap(scene) || scene.solver.model == Model::radial ||
        scene.solver.secondary_flow == Switch::off) {
        return;
    }
    const VortexGap outside = gap_outside_rotor(scene.instrument);
    bool is_doubted = false;
    for (std::size_t k = 0; k < report.history.rows.size(); ++k) {
        const double ratio = plan.rows[k].taylor_ratio;
        if (ratio > 1.0) {
            rheometry::TorqueRow& row = report.history.rows[k];
            row.torque_error +=
                (stability::vortex_torque_ratio(outside.relative_width(), ratio) - 1.0) *
                laminar_torque(scene, outside, std::abs(row.speed));
            is_doubted = true;
        }
    }
    if (is_doubted) {
        report.notes.emplace_back(
            "With a yield stress vortices past the onset are not solved: the torque there is the "
            "laminar one, and what vortices add to a Newtonian fluid's is in the error.");
        report.worst_relative_error = worst_relative_error(report.history.rows);
        report.reached = report.worst_relative_error <= scene.solver.accuracy;
    }
}

} // namespace searle::solvers::meridional
