#pragma once

#include "solvers/meridional/flow_level.hpp"

#include <memory>

namespace searle::solvers::meridional {

/// Half an axial period of Taylor vortices, one vortex, between two mirror planes: the rotor at
/// r = 1, the cup at r = 1 + gap. Lengths over the rotor's radius.
struct VortexCell {
    double gap{};    ///< > 0
    double height{}; ///< half of the axial wavelength, > 0
};

/// How a cell is divided: evenly, into columns x rows elements.
struct CellResolution {
    int degree{};
    int columns{};
    int rows{};
};

/// The cell with the rotor turning and the fluid at rest.
[[nodiscard]] std::unique_ptr<FlowLevel> cell_level(const VortexCell& cell,
                                                    const CellResolution& resolution);

/// Speed of the rotor at a height, over its mean speed: an imperfection that vortices grow from,
/// 1 + disturbance cos(pi z / height).
void disturb_rotor(const VortexCell& cell, const FlowSpace& space, double disturbance,
                   FlowState& state);

/// Torque of the laminar flow of a Newtonian fluid on the cell's piece of rotor, over 2 pi
/// viscosity speed radius^3: 2 height / (1 - 1 / (1 + gap)^2).
[[nodiscard]] double laminar_torque(const VortexCell& cell);

} // namespace searle::solvers::meridional
