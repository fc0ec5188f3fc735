#pragma once

#include "solvers/axisymmetric/swirl_law.hpp"
#include "solvers/meridional/flow_stepper.hpp"
#include "solvers/meridional/vortex_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::solvers::meridional {

/// One viscosity, 1.
class UnitViscosity final : public axisymmetric::EnergyDensity {
public:
    void slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                Eigen::ArrayXd& tangent) const override {
        secant.setOnes(rate.size());
        tangent.setOnes(rate.size());
    }
};

/// Half a wavelength of an axial wave number (times the gap's width).
/// @param gap  width over the bob's radius
inline VortexCell cell_of(double gap, double wave_number) {
    return {.gap = gap, .height = std::numbers::pi * gap / wave_number};
}

/// Exponential growth in one viscous time of a small disturbance of the flow without vortices, by
/// time steps.
/// @param viscous_time  d^2 / nu in units of 1 / omega
inline double vortex_growth(const VortexCell& cell, const FlowMaterial& material,
                            double viscous_time, const CellResolution& resolution) {
    const auto level = cell_level(cell, resolution);
    static_cast<void>(level->solve_creeping(material.law, 1e-14));
    FlowState state = level->state();
    const auto& position = level->space().swirl_space().position();
    for (int node = 0; node < level->space().nodes(); ++node) {
        state.velocity(node, 2) +=
            1e-4 * std::sin(std::numbers::pi * (position(node, 0) - 1.0) / cell.gap) *
            std::cos(std::numbers::pi * position(node, 1) / cell.height);
    }
    FlowStepper stepper(level->system(), material, state,
                        {.tolerance = 1e-10, .first_step = 1e-2 * viscous_time});
    stepper.begin({.start_time = 0.0, .speed = 1.0, .acceleration = 0.0});
    const auto amplitude_at = [&](double time) {
        while (stepper.time() < time) {
            EXPECT_TRUE(stepper.step(time));
        }
        return stepper.state().velocity.col(1).cwiseAbs().maxCoeff();
    };
    const double early = amplitude_at(2.0 * viscous_time);
    return std::log(amplitude_at(3.0 * viscous_time) / early);
}

/// Where the growth vanishes on the chord between two shares of the expected onset, 1 -+ spread.
template <class Growth>
double where_growth_vanishes(const Growth& growth, double spread) {
    const double below = growth(1.0 - spread);
    const double above = growth(1.0 + spread);
    return 1.0 - spread - 2.0 * spread * below / (above - below);
}

} // namespace searle::solvers::meridional
