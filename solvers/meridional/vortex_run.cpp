#include "solvers/meridional/vortex_run.hpp"

#include "solvers/meridional/history_run.hpp"
#include "solvers/meridional/vortex_cell.hpp"
#include "solvers/row_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::meridional {
namespace {

constexpr std::array<CellResolution, 6> resolutions{{{.degree = 5, .columns = 2, .rows = 2},
                                                     {.degree = 7, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 4, .rows = 4},
                                                     {.degree = 10, .columns = 4, .rows = 4},
                                                     {.degree = 10, .columns = 8, .rows = 8}}};
constexpr double first_tolerance = 0.1; ///< of a step, over the accuracy
constexpr double tolerance_fall = 0.2;
constexpr double rounding = 1e-5;
/// Torques are judged against themselves, or against this share of the fastest speed's.
constexpr double least_scale = 1e-3;

HistoryRun run_level(FlowLevel& level, const VortexCell& cell, const ScaledFluid& fluid,
                     double reference_speed, const rheometry::SpeedHistory& history,
                     RunSettings settings, double disturbance, const ProgressSink& progress) {
    FlowState profile = rest(level.space());
    disturb_rotor(cell, level.space(), disturbance, profile);
    settings.rotor_profile = profile.velocity.col(static_cast<Eigen::Index>(Component::rotation));
    FlowState start = rest(level.space());
    if (history.initial_speed != 0.0) {
        // Laminar and steady before the history begins.
        level.start_from_rest();
        static_cast<void>(level.solve_creeping(fluid.material(0.0).law, 1e-12));
        start = level.state();
        start.velocity *= history.initial_speed / reference_speed;
        start.pressure.setZero();
    }
    level.set_state(std::move(start));
    return run_history(level, fluid, reference_speed, history, settings, progress);
}

} // namespace

VortexRun vortex_run(const radial::AnnularGap& gap, double wavelength,
                     const laws::flow::AnyFlowLaw& law, double density, double disturbance,
                     const rheometry::SpeedHistory& history, std::span<const double> accuracies,
                     std::span<const std::size_t> field_rows, const ProgressSink& progress) {
    VortexRun result;
    const VortexCell cell{.gap = gap.outer_radius / gap.inner_radius - 1.0,
                          .height = 0.5 * wavelength / gap.inner_radius};
    const double reference_speed = history.fastest_speed();
    const radial::SteadyGapFlow fastest = radial::steady_gap_flow(gap, law, reference_speed);
    const ScaledFluid fluid(law, density, gap.inner_radius, reference_speed,
                            fastest.inner_wall_rate, rounding);
    const double scale =
        2.0 * std::numbers::pi * std::pow(gap.inner_radius, 2) * fluid.stress_scale() / cell.height;
    double tolerance = first_tolerance * *std::ranges::max_element(accuracies);
    HistoryRun last;
    std::vector<double> change_before;
    for (const CellResolution& resolution : resolutions) {
        if (result.levels > 1 && !may_follow(last)) {
            result.stopped =
                fmt::format("The vortices were followed on {} levels of resolution: the "
                            "next would take more work than a level may.",
                            result.levels);
            break;
        }
        const auto level = cell_level(cell, resolution);
        HistoryRun run;
        try {
            run = run_level(*level, cell, fluid, reference_speed, history,
                            {.tolerance = tolerance, .field_rows = field_rows}, disturbance,
                            progress);
        } catch (const Interrupted&) {
            if (result.levels < 2) {
                throw;
            }
            result.interrupted = true;
            break;
        }
        result.linear_solves += run.solves;
        last = run;
        if (run.too_dear && result.levels > 0) {
            result.stopped =
                fmt::format("The vortices were followed on {} levels of resolution: the "
                            "next took more work than a level may.",
                            result.levels);
            break;
        }
        result.stopped.clear();
        if (run.torque.size() < history.row_times.size()) {
            result.stopped = fmt::format(
                "The vortices could not be followed beyond t = {:.4g} s: {}.", run.end_time,
                run.too_dear ? "it took more work than a level may"
                             : "time steps became too short");
        }
        std::vector<double> torque;
        for (const double each : run.torque) {
            torque.push_back(scale * each);
        }
        const std::vector<double> before = std::exchange(result.torque, torque);
        const std::vector<double> change = level_changes(before, torque, history, tolerance);
        result.error = level_errors(change, std::exchange(change_before, change));
        for (std::size_t k = change.size(); k < torque.size(); ++k) {
            result.error.push_back(std::abs(torque[k]));
        }
        double worst = 0.0; // over what was asked
        for (std::size_t k = 0; k < torque.size(); ++k) {
            const double against =
                std::max(std::abs(torque[k]), least_scale * fastest.torque_per_length);
            worst = std::max(worst, result.error[k] / (against * accuracies[k]));
        }
        ++result.levels;
        result.elements = static_cast<int>(level->mesh().elements.size());
        result.unknowns = level->space().unknowns();
        result.time_steps = run.steps;
        result.fields = flow_fields_at_rows(
            *level, run.kept, {gap.inner_radius, reference_speed, fastest.inner_wall_rate}, law,
            history);
        result.reached =
            result.levels > 1 && result.torque.size() == history.row_times.size() && worst <= 1.0;
        if (result.reached || run.too_dear) {
            break;
        }
        tolerance *= tolerance_fall;
    }
    return result;
}

} // namespace searle::solvers::meridional
