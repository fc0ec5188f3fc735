#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "solvers/meridional/flow_level.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <cstddef>
#include <vector>

namespace searle::solvers::meridional {

/// Fields of rows, in place of the laminar flow's where there are vortices.
using RowFields = std::vector<rheometry::fields::SectionFields>;

[[nodiscard]] bool shows_vortex(const rheometry::fields::SectionFields& section);

/// One vortex takes the place of the laminar flow in the fields of its row, if that has any. Its
/// mirror planes, free surfaces to the solver, become open ends.
void show_vortex(rheometry::fields::SectionFields vortex, RowFields& fields);

/// The same for the rows of a steady series that turn at this speed.
/// @param speed  rad/s, > 0
/// @param level  its state is one vortex at this speed
void show_steady_vortex(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                        double speed, const FlowLevel& level, RowFields& fields);

/// Leaves only fields of the first `rows` rows.
void drop_fields_without_rows(std::size_t rows, RowFields& fields);

} // namespace searle::solvers::meridional
