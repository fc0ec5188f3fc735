#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/meridional/flow_material.hpp"
#include "solvers/meridional/steady_secondary_flow.hpp"
#include "solvers/meridional/vortex_cell.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace searle::solvers::meridional {

/// Steady Taylor vortices between an endless turning bob and a cup at rest, in an axially periodic
/// cell of given height (docs/secondary-flow.md). Found by following the flow of a slightly uneven
/// rotor from below the onset, where it is unique, to the speed asked for, and then making the
/// rotor even.
class SteadyVortices {
public:
    /// @param wavelength  axial period: two vortices, m, > 0
    /// @param density     kg/m^3, > 0
    SteadyVortices(const radial::AnnularGap& gap, double wavelength,
                   const laws::flow::AnyFlowLaw& law, double density);

    /// Torque over the laminar flow's, both at `speed`, rad/s, > 0; 1 below the onset. Best called
    /// with rising speeds. May throw Interrupted.
    /// @param accuracy  asked-for relative error of the torque, > 0
    [[nodiscard]] InertiaFactor at(double speed, double accuracy,
                                   const ProgressSink& progress = {});

    /// The vortices that the last at() found, over the speed; null where there are none.
    [[nodiscard]] const FlowLevel* flow() const { return flow_; }

    [[nodiscard]] long factorisations() const;

private:
    struct Level {
        std::unique_ptr<FlowLevel> flow;
        FlowState uneven;  ///< flow of the uneven rotor ...
        double at_speed{}; ///< ... at this speed; 0: none yet
    };
    [[nodiscard]] ScaledFluid fluid_at(double speed) const;
    [[nodiscard]] Level& level(std::size_t index);
    /// The uneven rotor's flow becomes that at a higher speed.
    bool follow(Level& level, double to, double accuracy);
    /// The level's state becomes the even rotor's flow, from the uneven one at the same speed.
    bool even_out(Level& level, double speed, double accuracy);

    radial::AnnularGap gap_;
    VortexCell cell_;
    laws::flow::AnyFlowLaw law_;
    double density_;
    std::optional<double> start_speed_; ///< of the way, rad/s, once known; the same on all levels
    std::vector<Level> levels_;
    const FlowLevel* flow_{};
    std::size_t first_level_{}; ///< the coarsest one that holds the flow
};

} // namespace searle::solvers::meridional
