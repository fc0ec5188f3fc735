#pragma once

#include "rheometry/fields/section_fields.hpp"
#include "solvers/plan.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/scene.hpp"

#include <span>
#include <vector>

namespace searle::solvers::radial {

/// The flow in the gaps at some rows of a finished solution, as strips of the instrument's height
/// (names in section_fields.hpp); of the box across its gap, with x in place of r. Steady rows
/// follow from the torque; rows with inertia are computed again on at most 96 elements.
/// @param rows  numbers from 1, increasing
[[nodiscard]] std::vector<rheometry::fields::SectionFields>
gap_fields(const Scene& scene, const RadialReport& solution, std::span<const std::size_t> rows);

} // namespace searle::solvers::radial
