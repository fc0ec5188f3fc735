#include "solvers/meridional/steady_vortices.hpp"

#include "solvers/stability/onset_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace searle::solvers::meridional {
namespace {

constexpr std::array<CellResolution, 6> resolutions{{{.degree = 5, .columns = 2, .rows = 2},
                                                     {.degree = 7, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 2, .rows = 2},
                                                     {.degree = 9, .columns = 4, .rows = 4},
                                                     {.degree = 10, .columns = 4, .rows = 4},
                                                     {.degree = 10, .columns = 8, .rows = 8}}};
/// How uneven the rotor is on the way: so much that Newton's method gets round the onset, where an
/// even rotor's flow has two branches.
constexpr double unevenness = 2e-2;
/// The way starts at this share of the onset.
constexpr double start_share = 0.6;
constexpr double onset_tolerance = 1e-2;
constexpr double longest_stride = 1.05;
constexpr double shortest_stride = 1.002;
constexpr double path_tolerance = 1e-3;
constexpr double newton_share = 0.01;
constexpr double rounding = 1e-5;
/// Velocities in r and z below this share of the rotor's are no vortices.
constexpr double no_vortices = 1e-6;

double secondary_speed(const FlowState& state) {
    return state.velocity.leftCols(2).cwiseAbs().maxCoeff();
}

} // namespace

SteadyVortices::SteadyVortices(const radial::AnnularGap& gap, double wavelength,
                               const laws::flow::AnyFlowLaw& law, double density)
    : gap_(gap), cell_{.gap = gap.outer_radius / gap.inner_radius - 1.0,
                       .height = 0.5 * wavelength / gap.inner_radius},
      law_(law), density_(density) {}

ScaledFluid SteadyVortices::fluid_at(double speed) const {
    const double wall_rate = radial::steady_gap_flow(gap_, law_, speed).inner_wall_rate;
    return {law_, density_, gap_.inner_radius, speed, wall_rate, rounding};
}

SteadyVortices::Level& SteadyVortices::level(std::size_t index) {
    while (levels_.size() <= index) {
        levels_.push_back({.flow = cell_level(cell_, resolutions[levels_.size()]), .uneven = {}});
    }
    return levels_[index];
}

bool SteadyVortices::follow(Level& here, double to, double accuracy) {
    FlowLevel& flow = *here.flow;
    if (here.at_speed == 0.0 || here.at_speed > to) {
        if (!start_speed_) {
            const auto onset = stability::critical_speed(gap_, law_, density_, to, onset_tolerance);
            start_speed_ =
                onset ? start_share * onset->speed : std::numeric_limits<double>::infinity();
        }
        const double slow = std::min(to, *start_speed_);
        flow.start_from_rest();
        static_cast<void>(
            flow.solve_creeping(fluid_at(slow).material(0.0).law, path_tolerance * accuracy));
        FlowState state = flow.state();
        disturb_rotor(cell_, flow.space(), unevenness, state);
        flow.set_state(std::move(state));
        if (!flow.solve_steady(fluid_at(slow).material(), path_tolerance)) {
            return false;
        }
        here.at_speed = slow;
    } else {
        flow.set_state(here.uneven);
    }
    double stride = longest_stride;
    while (here.at_speed < to) {
        const double next = std::min(to, here.at_speed * stride);
        if (flow.solve_steady(fluid_at(next).material(), path_tolerance)) {
            here.at_speed = next;
        } else {
            stride = std::sqrt(std::min(stride, next / here.at_speed));
            if (stride < shortest_stride) {
                return false;
            }
        }
    }
    here.uneven = flow.state();
    return true;
}

bool SteadyVortices::even_out(Level& here, double speed, double accuracy) {
    FlowLevel& flow = *here.flow;
    for (const double left : {0.3 * unevenness, 0.1 * unevenness, 0.0}) {
        FlowState state = flow.state();
        disturb_rotor(cell_, flow.space(), left, state);
        flow.set_state(std::move(state));
        const double tolerance = left > 0.0 ? path_tolerance : newton_share * accuracy;
        if (!flow.solve_steady(fluid_at(speed).material(), tolerance)) {
            return false;
        }
    }
    return true;
}

InertiaFactor SteadyVortices::at(double speed, double accuracy, const ProgressSink& progress) {
    InertiaFactor result;
    double before = 0.0;
    flow_ = nullptr;
    const ScaledFluid fluid = fluid_at(speed);
    for (std::size_t index = first_level_; index < resolutions.size(); ++index) {
        if (progress) {
            progress(static_cast<double>(index) / resolutions.size(),
                     "Taylor vortices, level " + std::to_string(index + 1));
        }
        Level& here = level(index);
        FlowLevel& flow = *here.flow;
        if (result.levels == 0) {
            if (!follow(here, speed, accuracy) || !even_out(here, speed, accuracy)) {
                continue;
            }
            first_level_ = index;
        } else {
            flow.start_from_rest();
            flow.start_from(*levels_[index - 1].flow);
            if (!flow.solve_steady(fluid.material(), newton_share * accuracy)) {
                continue;
            }
        }
        double factor = 1.0;
        flow_ = secondary_speed(flow.state()) > no_vortices ? &flow : nullptr;
        if (flow_ != nullptr) {
            const FlowState vortices = flow.state();
            const double torque = flow.steady_torque(fluid.material());
            flow.start_from_rest();
            static_cast<void>(
                flow.solve_creeping(fluid.material(0.0).law, newton_share * accuracy));
            factor = torque / flow.steady_torque(fluid.material(0.0));
            flow.set_state(vortices);
        }
        ++result.levels;
        result.factor = factor;
        result.unknowns = flow.space().unknowns();
        result.relative_error = std::abs(factor - before) / factor;
        before = factor;
        result.reached = result.levels > 1 && result.relative_error <= accuracy;
        if (result.reached) {
            break;
        }
    }
    return result;
}

long SteadyVortices::factorisations() const {
    long sum = 0;
    for (const Level& each : levels_) {
        sum += each.flow->system().factorisations();
    }
    return sum;
}

} // namespace searle::solvers::meridional
