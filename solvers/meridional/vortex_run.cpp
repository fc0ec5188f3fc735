#include "solvers/meridional/vortex_run.hpp"

#include "solvers/meridional/history_run.hpp"
#include "solvers/meridional/vortex_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::meridional {
namespace {

constexpr std::array<CellResolution, 5> resolutions{{{.degree = 5, .columns = 2, .rows = 2},
                                                     {.degree = 7, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 4, .rows = 4},
                                                     {.degree = 10, .columns = 8, .rows = 8}}};
constexpr double first_tolerance = 0.1; ///< of a step, over the accuracy
constexpr double tolerance_fall = 0.2;
constexpr double rounding = 1e-5;
/// Torques are judged against themselves, or against this share of the fastest speed's.
constexpr double least_scale = 1e-3;

HistoryRun run_level(FlowLevel& level, const VortexCell& cell, const ScaledFluid& fluid,
                     double reference_speed, const rheometry::SpeedHistory& history,
                     double tolerance, double disturbance, const ProgressSink& progress) {
    FlowState profile = rest(level.space());
    disturb_rotor(cell, level.space(), disturbance, profile);
    const Eigen::VectorXd rotor =
        profile.velocity.col(static_cast<Eigen::Index>(Component::rotation));
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
    return run_history(level, fluid, reference_speed, history, tolerance, progress, rotor);
}

} // namespace

VortexRun vortex_run(const radial::AnnularGap& gap, double wavelength,
                     const laws::flow::AnyFlowLaw& law, double density, double disturbance,
                     const rheometry::SpeedHistory& history, std::span<const double> accuracies,
                     const ProgressSink& progress) {
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
    for (const CellResolution& resolution : resolutions) {
        const auto level = cell_level(cell, resolution);
        const HistoryRun run = run_level(*level, cell, fluid, reference_speed, history, tolerance,
                                         disturbance, progress);
        const std::vector<double> before = std::exchange(result.torque, {});
        result.error.clear();
        double worst = 0.0; // over what was asked
        for (std::size_t k = 0; k < run.torque.size(); ++k) {
            const double torque = scale * run.torque[k];
            const double change =
                k < before.size() ? std::abs(torque - before[k]) : std::abs(torque);
            const double against =
                std::max(std::abs(torque), least_scale * fastest.torque_per_length);
            worst = std::max(worst, change / (against * accuracies[k]));
            result.torque.push_back(torque);
            result.error.push_back(change);
        }
        ++result.levels;
        result.elements = static_cast<int>(level->mesh().elements.size());
        result.unknowns = level->space().unknowns();
        result.time_steps = run.steps;
        result.linear_solves += run.solves;
        result.reached =
            result.levels > 1 && result.torque.size() == history.row_times.size() && worst <= 1.0;
        if (result.reached) {
            break;
        }
        tolerance *= tolerance_fall;
    }
    return result;
}

} // namespace searle::solvers::meridional
