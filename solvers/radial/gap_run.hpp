#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/radial/gap_grid.hpp"

#include <functional>
#include <limits>
#include <vector>

namespace searle::solvers::radial {

/// How finely one run of a gap resolves space and time.
struct GapResolution {
    int elements{};
    double layer{};           ///< thickness for graded_grid, m
    int steps_per_row = 1;    ///< at least so many steps from row to row
    double first_step = 1e-2; ///< after a kink of the speed, over the time to the next row
    double step_tolerance{};  ///< local error of the flux in a step, relative to the largest flux
    /// Evaluations of the law over the gap, after which it gives up.
    long most_assemblies = std::numeric_limits<long>::max();
};

struct FluxField;

/// What one row of a run hands out.
struct GapRow {
    double flux{};                      ///< at the moving wall, see run_gap
    double rounding{};                  ///< relative error of `flux` by rounding, estimated
    const FluxField* profile = nullptr; ///< over the grid of the resolution; of the row alone
};
using RowSink = std::function<void(std::size_t row, const GapRow&)>;

/// A gap's transient at one resolution.
struct GapRun {
    bool finished{}; ///< false: a step could not be taken, or most_assemblies are over; the rows
                     ///< before it are good
    long steps{};
    long rejected{};
    long linear_solves{};
    long assemblies{};
    /// | change of momentum - integral of the flux difference | / integral of |flux| over time. The
    /// scheme conserves momentum identically, so this checks the bookkeeping, not the flow.
    double momentum_defect{};
};

/// Size of the flux of steady flow at a speed difference > 0 of the walls, >= 0: the same all over
/// the gap.
[[nodiscard]] double steady_flux_size(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
                                      double speed);

/// Flux F at the moving wall: r^2 tau (N) in an annulus, tau (Pa) when planar, tau > 0 for dw/dx >
/// 0.
///
/// Integrates rho m dw/dt = dF/dx, dw/dx = rate(F/a)/b over the speed history, the wall that does
/// not move at speed 0. Steps land on every row, kink and jump. A jump is followed by one very
/// small step of implicit Euler; else steps are Kennedy & Carpenter's ESDIRK4(3)6L[2]SA with the
/// embedded error mapped to a change of flux. Starts from rest, or from steady flow at
/// history.initial_speed.
/// @param between_steps  called every few dozen steps; may throw to stop the run
/// @param at_row  called at each row with its index and what was found there; may throw to stop the
/// run
[[nodiscard]] GapRun run_gap(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
                             const rheometry::SpeedHistory& history,
                             const GapResolution& resolution, const RowSink& at_row,
                             const std::function<void()>& between_steps = {});

} // namespace searle::solvers::radial
