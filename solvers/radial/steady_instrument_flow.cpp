#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::radial {
namespace {

struct Solve {
    const laws::flow::AnyFlowLaw& law;
    double speed; ///< magnitude, > 0

    SteadyInstrumentFlow annulus(double inner, double outer, double height) const {
        const SteadyGapFlow flow = steady_gap_flow({inner, outer}, law, speed);
        return {.torque = flow.torque_per_length * height,
                .relative_error = flow.relative_error,
                .rotor_wall_rate = flow.inner_wall_rate,
                .yield_radius = flow.yield_radius,
                .partly_sheared = flow.partly_sheared};
    }
    SteadyInstrumentFlow operator()(const geometry::ConcentricCylinders& cylinders) const {
        return annulus(cylinders.bob_radius, cylinders.cup_radius, cylinders.height);
    }
    SteadyInstrumentFlow operator()(const geometry::DinBob& bob) const {
        return annulus(bob.bob_radius, bob.cup_radius, bob.height());
    }
    SteadyInstrumentFlow operator()(const geometry::DoubleGap& gaps) const {
        const SteadyGapFlow inner = steady_gap_flow({gaps.radii[0], gaps.radii[1]}, law, speed);
        const SteadyGapFlow outer = steady_gap_flow({gaps.radii[2], gaps.radii[3]}, law, speed);
        return {.torque = (inner.torque_per_length + outer.torque_per_length) * gaps.height,
                .relative_error = std::max(inner.relative_error, outer.relative_error),
                .rotor_wall_rate = outer.inner_wall_rate,
                .yield_radius = outer.yield_radius,
                .partly_sheared = inner.partly_sheared || outer.partly_sheared};
    }
    SteadyInstrumentFlow operator()(const geometry::Box& box) const {
        const double rate = speed / box.gap;
        return {.torque = laws::flow::stress(law, rate) * box.wall_area(),
                .relative_error = 1e-14,
                .rotor_wall_rate = rate};
    }
};

} // namespace

SteadyInstrumentFlow steady_instrument_flow(const geometry::Instrument& instrument,
                                            const laws::flow::AnyFlowLaw& law, double speed) {
    if (speed == 0.0) {
        return {};
    }
    SteadyInstrumentFlow flow = std::visit(Solve{law, std::abs(speed)}, instrument);
    flow.torque = std::copysign(flow.torque, speed);
    return flow;
}

} // namespace searle::solvers::radial
