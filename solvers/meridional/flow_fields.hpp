#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/meridional/flow_level.hpp"

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

namespace searle::solvers::meridional {

/// What a level's numbers are over.
struct FieldScales {
    double length{};    ///< m, the rotor's radius
    double speed{};     ///< rad/s; < 0: the rotor of a steady flow turns backwards
    double wall_rate{}; ///< 1/s, a typical rate of shear
};

/// A flow on a level as fields in SI, stream function included (names in section_fields.hpp). Row
/// and time are left to the caller, and so is the speed where `scales` do not say it.
/// @param velocity  of each node, over scales (FlowState::velocity)
[[nodiscard]] rheometry::fields::SectionFields flow_fields(const FlowLevel& level,
                                                           const Eigen::MatrixX3d& velocity,
                                                           const FieldScales& scales,
                                                           const laws::flow::AnyFlowLaw& law);

/// The flow at a row.
struct RowVelocity {
    std::size_t row{}; ///< from 1
    Eigen::MatrixX3d velocity;
};

/// The flow at rows of a history, by the scales of its reference speed.
[[nodiscard]] std::vector<rheometry::fields::SectionFields>
flow_fields_at_rows(const FlowLevel& level, std::span<const RowVelocity> rows,
                    const FieldScales& scales, const laws::flow::AnyFlowLaw& law,
                    const rheometry::SpeedHistory& history);

} // namespace searle::solvers::meridional
