#include "solvers/plan_steady_curve.hpp"

#include "solvers/plan_chambers.hpp"
#include "solvers/radial/rotor_gaps.hpp"
#include "solvers/radial/transient_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::solvers {
namespace {

InstrumentGap annular(double inner, double outer, double height, TurningWall wall) {
    return {.annulus = {inner, outer},
            .wall = wall,
            .plane_width = 0.0,
            .torque_per_stress = 2.0 * std::numbers::pi * inner * inner * height,
            .torque_per_response = height};
}

struct GapsOf {
    std::vector<InstrumentGap> operator()(const geometry::ConcentricCylinders& cylinders) const {
        return {annular(cylinders.bob_radius, cylinders.cup_radius, cylinders.height,
                        TurningWall::inner)};
    }
    std::vector<InstrumentGap> operator()(const geometry::DinBob& bob) const {
        return {annular(bob.bob_radius, bob.cup_radius, bob.height(), TurningWall::inner)};
    }
    std::vector<InstrumentGap> operator()(const geometry::DoubleGap& gaps) const {
        return {annular(gaps.radii[0], gaps.radii[1], gaps.height, TurningWall::outer),
                annular(gaps.radii[2], gaps.radii[3], gaps.height, TurningWall::inner)};
    }
    std::vector<InstrumentGap> operator()(const geometry::Box& box) const {
        return {{.annulus = {},
                 .wall = TurningWall::inner,
                 .plane_width = box.gap,
                 .torque_per_stress = box.wall_area(),
                 .torque_per_response = box.wall_area()}};
    }
};

/// Every positive value of a state, so that interpolation and scaling treat all alike.
template <class State, class Function>
void for_each_value(State& state, std::size_t gaps, const Function& function) {
    function(state.torque);
    for (std::size_t g = 0; g < gaps; ++g) {
        function(state.gaps[g].inner_stress);
        function(state.gaps[g].inner_rate);
        function(state.gaps[g].response.inertia);
        function(state.gaps[g].response.decay_time);
    }
}

constexpr double tiny = std::numeric_limits<double>::min();

} // namespace

std::vector<InstrumentGap> gaps_of(const geometry::Instrument& instrument) {
    return std::visit(GapsOf{}, instrument);
}

SteadyCurve::SteadyCurve(const geometry::Instrument& instrument, const Fluid& fluid,
                         std::span<const double> speeds)
    : instrument_(instrument), fluid_(fluid), gaps_(gaps_of(instrument)),
      linear_(std::holds_alternative<laws::flow::Newtonian>(fluid.law)),
      smallest_(std::numeric_limits<double>::infinity()) {
    for (const double speed : speeds) {
        if (speed != 0.0) {
            smallest_ = std::min(smallest_, std::abs(speed));
            largest_ = std::max(largest_, std::abs(speed));
        }
    }
    if (at_rest_only()) {
        return;
    }
    if (linear_) {
        linear_state_ = solve(1.0);
    } else if (speeds.size() > direct_limit) {
        constexpr double wanted_spacing = 0.05;
        const double range = std::log(largest_ / smallest_);
        const auto intervals =
            static_cast<std::size_t>(std::clamp(std::ceil(range / wanted_spacing), 4.0, 600.0));
        log_spacing_ = range / static_cast<double>(intervals);
        for (std::size_t i = 0; i <= intervals && range > 0.0; ++i) {
            nodes_.push_back(solve(smallest_ * std::exp(log_spacing_ * static_cast<double>(i))));
            for_each_value(nodes_.back(), gaps_.size(),
                           [](double& value) { value = std::log(std::max(value, tiny)); });
        }
    }
}

double SteadyCurve::yield_torque() const {
    return radial::yield_torque(radial::rotor_gaps(instrument_, fluid_.density), fluid_.law);
}

SteadyState SteadyCurve::solve(double speed) const {
    SteadyState state;
    state.chambers = chamber_responses(instrument_, fluid_, speed);
    for (std::size_t g = 0; g < gaps_.size(); ++g) {
        const InstrumentGap& gap = gaps_[g];
        GapState& here = state.gaps[g];
        if (gap.plane_width > 0.0) {
            here.inner_rate = speed / gap.plane_width;
            here.inner_stress = laws::flow::stress(fluid_.law, here.inner_rate);
            here.response =
                plane_gap_response(gap.plane_width, fluid_.law, fluid_.density, here.inner_rate);
        } else {
            const radial::SteadyGapFlow flow =
                radial::steady_gap_flow(gap.annulus, fluid_.law, speed);
            here.inner_rate = flow.inner_wall_rate;
            here.inner_stress = flow.inner_wall_stress;
            here.response = gap_response(gap.annulus, fluid_.law, fluid_.density, flow, gap.wall);
        }
        here.response.inertia *= gap.torque_per_response;
        state.torque += here.inner_stress * gap.torque_per_stress;
    }
    return state;
}

SteadyState SteadyCurve::interpolate(double speed) const {
    // Cubic through four equally spaced nodes around the speed.
    const double position = std::log(speed / smallest_) / log_spacing_;
    const auto last_start = static_cast<double>(nodes_.size() - 4);
    const auto start =
        static_cast<std::size_t>(std::clamp(std::floor(position) - 1.0, 0.0, last_start));
    const double t = position - static_cast<double>(start);
    const std::array<double, 4> weights{
        -(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
        -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0};
    SteadyState state;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        std::array<double, 9> values{};
        std::size_t count = 0;
        for_each_value(nodes_[start + k], gaps_.size(),
                       [&](const double& value) { values[count++] = weights[k] * value; });
        std::size_t index = 0;
        for_each_value(state, gaps_.size(), [&](double& value) { value += values[index++]; });
    }
    for_each_value(state, gaps_.size(), [](double& value) { value = std::exp(value); });
    state.chambers = chamber_responses(instrument_, fluid_, speed);
    return state;
}

const SteadyState& SteadyCurve::at(double speed) {
    const double magnitude = std::max(std::abs(speed), smallest_);
    if (linear_) {
        current_ = linear_state_;
        current_.torque *= magnitude;
        for (GapState& gap : current_.gaps) {
            gap.inner_stress *= magnitude;
            gap.inner_rate *= magnitude;
        }
        return current_;
    }
    if (!nodes_.empty()) {
        current_ = interpolate(magnitude);
        return current_;
    }
    const auto [place, is_new] = solved_.try_emplace(magnitude);
    if (is_new) {
        place->second = solve(magnitude);
    }
    return place->second;
}

} // namespace searle::solvers
