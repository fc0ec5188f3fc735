#include "solvers/meridional/steady_secondary_flow.hpp"

#include "solvers/radial/annular_gap.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace searle::solvers::meridional {
namespace {

constexpr std::array<FlowResolution, 6> resolutions{
    {{.degree = 3, .smallest = 5e-2, .largest = 0.5, .beside = 8.0},
     {.degree = 4, .smallest = 5e-2, .largest = 0.5, .beside = 8.0},
     {.degree = 5, .smallest = 5e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 7, .smallest = 5e-2, .largest = 0.5, .beside = 2.0},
     {.degree = 7, .smallest = 1e-2, .largest = 0.25, .beside = 2.0},
     {.degree = 9, .smallest = 1e-2, .largest = 0.25, .beside = 2.0}}};
/// Below this Reynolds number Newton's method finds the flow from the creeping one.
constexpr double easy_reynolds = 60.0;
/// Speeds along the way rise by at most this factor ...
constexpr double longest_stride = 2.5;
/// ... and when Newton's method fails by less and less, down to this; a level that needs shorter
/// ones is too coarse for the flow, and costs more than the next one.
constexpr double shortest_stride = 1.02;
constexpr double shortest_with_finer = 1.1;
constexpr double path_tolerance = 3e-2; ///< of the velocities on the way
/// Rounding of the yield surface on the first level, halved on each further one.
constexpr double first_yield_rounding = 2e-2;
constexpr double smooth_rounding = 1e-5;    ///< of laws without a yield stress, at rest
constexpr double creeping_tolerance = 1e-4; ///< of the energy, over the accuracy
/// Past the onset of Taylor vortices there are many steady flows; further levels hop between them.
/// From the first that holds a flow there are two.
constexpr std::size_t levels_past_onset = 4;
constexpr double newton_share = 0.1; ///< of the accuracy that Newton's method may leave
/// What is left of both iterations in the torque, of the accuracy: an estimate from levels does not
/// see it where inertia is so weak that it is all there is.
constexpr double iteration_share = 1e-3;
/// Safety factor of two levels' difference (Roache 1994, J. Fluids Eng. 116, 405): around an ISO
/// bob the first two factors of water cross at some speed.
constexpr double safety_of_two = 3.0;
/// Of more levels: at least this share of the last difference, or of a tenth of the one before.
constexpr double least_share = 0.6;
constexpr double earlier_share = 0.1;
/// Of a fluid with a yield stress the changes fall with the power 0.6 of the rounding, which is
/// halved (Bingham fluids around DIN bobs), or by less where they scatter.
constexpr double usual_yielding = 0.65;
constexpr double slowest_yielding = 0.8;
constexpr double safety_of_series = 1.25;
/// Two levels, which may cross, leave at least this much of what inertia adds (9 % was seen).
constexpr double least_of_two_yielding = 0.15;
/// A thickening fluid's Reynolds number may not fall with the speed.
constexpr int most_halvings = 40;
/// Share of the work at one speed where the onset of Taylor vortices is left this many times
/// behind.
constexpr double share_far_past_onset = 0.1;
constexpr double far_past_onset = 10.0;

/// @param before  the change of the level before; 0 where there is none
/// @param effect  |F - 1|, of a fluid with a yield stress; else 0
double error_from_changes(double change, double before, double effect) {
    if (before == 0.0) {
        return std::max(safety_of_two * change, least_of_two_yielding * effect);
    }
    if (effect > 0.0) {
        const double fall = std::clamp(change / before, usual_yielding, slowest_yielding);
        return safety_of_series * std::max(fall / (1.0 - fall) * change, earlier_share * before);
    }
    // Later changes shrink at least as the last two did; half of that is believed.
    const double share = std::clamp(2.0 * change / before, least_share, 1.0);
    return share * std::max(change, earlier_share * before);
}

} // namespace

SteadySecondaryFlow::SteadySecondaryFlow(const geometry::DinBob& bob,
                                         const laws::flow::AnyFlowLaw& law, double density,
                                         double accuracy)
    : bob_(bob), law_(law), density_(density), accuracy_(accuracy) {}

double SteadySecondaryFlow::rounding_of(std::size_t level) const {
    return laws::flow::yield_stress(law_) > 0.0
               ? first_yield_rounding * std::pow(0.5, static_cast<double>(level))
               : smooth_rounding;
}

ScaledFluid SteadySecondaryFlow::fluid_at(double speed, double rounding) const {
    const double wall_rate =
        radial::steady_gap_flow({bob_.bob_radius, bob_.cup_radius}, law_, speed).inner_wall_rate;
    return {law_, density_, bob_.bob_radius, speed, wall_rate, rounding};
}

SteadySecondaryFlow::Level& SteadySecondaryFlow::level(std::size_t index) {
    while (levels_.size() <= index) {
        levels_.push_back({std::make_unique<FlowLevel>(bob_, resolutions[levels_.size()]), {}});
    }
    return levels_[index];
}

void SteadySecondaryFlow::creep(std::size_t index, double speed) {
    Level& here = level(index);
    const double tolerance = creeping_tolerance * accuracy_;
    double rounding = rounding_of(index);
    if (here.creeping) {
        here.flow->set_state(*here.creeping);
    } else {
        here.flow->start_from_rest();
        if (!std::holds_alternative<laws::flow::Newtonian>(law_)) {
            rounding = 1.0;
        }
    }
    for (;; rounding = std::max(0.1 * rounding, rounding_of(index))) {
        const ScaledFluid fluid = fluid_at(speed, rounding);
        static_cast<void>(here.flow->solve_creeping(fluid.material(0.0).law, tolerance));
        if (rounding <= rounding_of(index)) {
            break;
        }
    }
    here.creeping = here.flow->state();
}

double SteadySecondaryFlow::creeping_torque(std::size_t index, double speed) {
    FlowLevel& flow = *level(index).flow;
    const FlowState state = flow.state();
    creep(index, speed);
    const double torque = flow.steady_torque(fluid_at(speed, index).material(0.0));
    flow.set_state(state);
    return torque;
}

bool SteadySecondaryFlow::solve_steady(FlowLevel& flow, const FlowMaterial& material,
                                       double tolerance) {
    if (work_left_ < 0.0) {
        return false;
    }
    const long before = flow.system().factorisations();
    const bool solved = flow.solve_steady(material, tolerance, report_);
    const double done = static_cast<double>(flow.system().factorisations() - before) *
                        static_cast<double>(flow.space().unknowns()) *
                        std::pow(flow.space().degree(), 2);
    work_left_ -= done;
    work_ += done;
    return solved;
}

bool SteadySecondaryFlow::follow(std::size_t index, double from, double to) {
    FlowLevel& flow = *level(index).flow;
    double at = from;
    double stride = longest_stride;
    const double shortest = index + 1 < resolutions.size() ? shortest_with_finer : shortest_stride;
    FlowState slower; // the flow before the present one, `back` times as fast
    double back = 0.0;
    while (at != to) {
        const double next = std::abs(std::log(to / at)) <= std::log(stride) ? to
                            : to > at                                       ? at * stride
                                                                            : at / stride;
        const double tolerance = next == to ? newton_share * accuracy_ : path_tolerance;
        const ScaledFluid fluid = fluid_at(next, index);
        const FlowState here = flow.state();
        if (back != 0.0) {
            FlowState ahead = here;
            const double share = std::log(next / at) / std::log(back);
            add(ahead, here, -share);
            add(ahead, slower, share);
            flow.set_state(std::move(ahead));
        }
        if (solve_steady(flow, fluid.material(), tolerance)) {
            slower = here;
            back = at / next;
            at = next;
            continue;
        }
        flow.set_state(here);
        stride = std::sqrt(std::min(stride, std::max(next / at, at / next)));
        if (stride < shortest) {
            stuck_at_ = at;
            return false;
        }
    }
    return true;
}

bool SteadySecondaryFlow::follow_inertia(std::size_t index, double speed) {
    const ScaledFluid fluid = fluid_at(speed, index);
    creep(index, speed);
    double share = std::min(1.0, easy_reynolds / fluid.reynolds());
    while (solve_steady(*level(index).flow, fluid.material(share), newton_share * accuracy_)) {
        if (share == 1.0) {
            return true;
        }
        share = std::min(1.0, longest_stride * share);
    }
    return false;
}

bool SteadySecondaryFlow::reach(std::size_t index, double speed) {
    FlowLevel& flow = *level(index).flow;
    const std::optional<double> of_coarser = std::exchange(stuck_at_, {});
    if (speed_of_first_ && index == first_level_ && *speed_of_first_ <= speed &&
        follow(index, *speed_of_first_, speed)) {
        return true;
    }
    if (of_coarser) {
        flow.start_from(*levels_[index - 1].flow);
        if (solve_steady(flow, fluid_at(*of_coarser, index).material(), path_tolerance) &&
            follow(index, *of_coarser, speed)) {
            return true;
        }
    }
    // From the creeping flow at a speed where that is near.
    stuck_at_.reset();
    double slow = speed;
    for (int halving = 0; fluid_at(slow, index).reynolds() > easy_reynolds; ++halving) {
        if (halving == most_halvings) {
            return follow_inertia(index, speed);
        }
        slow *= 0.5;
    }
    const ScaledFluid fluid = fluid_at(slow, index);
    creep(index, slow);
    return solve_steady(flow, fluid.material(), newton_share * accuracy_) &&
           follow(index, slow, speed);
}

InertiaFactor SteadySecondaryFlow::at(double speed, const ProgressSink& progress, double work) {
    if (!latest_ || latest_->first != speed) {
        latest_.reset(); // may be left by an exception
        work_left_ = work;
        const InertiaFactor found = solve_at(speed, progress);
        latest_.emplace(speed, found);
    }
    return latest_->second;
}

InertiaFactor SteadySecondaryFlow::solve_at(double speed, const ProgressSink& progress) {
    InertiaFactor result;
    stuck_at_.reset();
    double before = 0.0;
    double change_before = 0.0;
    int found = 0;
    const double gap = bob_.radius_ratio() - 1.0;
    const double onsets = fluid_at(speed, smooth_rounding).reynolds() * gap /
                          stability::taylor_threshold(gap).reynolds;
    const bool is_past_onset = onsets > 1.0;
    const bool yields = laws::flow::yield_stress(law_) > 0.0;
    if (onsets > far_past_onset) {
        work_left_ *= share_far_past_onset;
    }
    const auto most_levels = [&] {
        return is_past_onset
                   ? std::min(resolutions.size(), std::max(levels_past_onset, first_level_ + 2))
                   : resolutions.size();
    };
    for (std::size_t index = first_level_; index < most_levels() && work_left_ > 0.0; ++index) {
        report_ = [&progress, index] {
            if (progress) {
                progress(static_cast<double>(index) / resolutions.size(),
                         "secondary flow, level " + std::to_string(index + 1));
            }
        };
        report_();
        const ScaledFluid fluid = fluid_at(speed, index);
        FlowLevel& flow = *level(index).flow;
        bool solved = false;
        if (found > 0) {
            flow.start_from(*levels_[index - 1].flow);
            solved = solve_steady(flow, fluid.material(), newton_share * accuracy_);
        } else {
            solved = reach(index, speed);
            speed_of_first_.reset();
            if (solved) {
                first_level_ = index;
                speed_of_first_ = speed;
            }
        }
        if (!solved) {
            // The level is too coarse to hold the flow; the next one may.
            found = 0;
            continue;
        }
        last_level_ = index;
        const double factor = flow.steady_torque(fluid.material()) / creeping_torque(index, speed);
        ++found;
        result.factor = factor;
        result.levels = found;
        result.unknowns = flow.space().unknowns();
        if (found == 1) {
            result.relative_error = std::abs(factor - 1.0);
        } else {
            const double change = std::abs(factor - before) / factor;
            result.relative_error = error_from_changes(change, found > 2 ? change_before : 0.0,
                                                       yields ? std::abs(factor - 1.0) : 0.0);
            change_before = change;
        }
        result.relative_error += iteration_share * accuracy_;
        before = factor;
        result.reached = result.relative_error <= accuracy_;
        if (result.reached) {
            break;
        }
    }
    report_ = {};
    return result;
}

LeadingDisturbance SteadySecondaryFlow::leading_disturbance_at(double speed,
                                                               const ProgressSink& progress) {
    return leading_disturbance(*levels_.at(last_level_).flow,
                               fluid_at(speed, last_level_).material(), progress);
}

FlowLevel* SteadySecondaryFlow::finest() {
    return levels_.empty() ? nullptr : levels_[last_level_].flow.get();
}

long SteadySecondaryFlow::factorisations() const {
    long sum = 0;
    for (const Level& each : levels_) {
        sum += each.flow->system().factorisations();
    }
    return sum;
}

} // namespace searle::solvers::meridional
