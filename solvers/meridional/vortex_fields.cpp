#include "solvers/meridional/vortex_fields.hpp"

#include "solvers/meridional/flow_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace searle::solvers::meridional {

using rheometry::fields::OutlineEdge;
using rheometry::fields::OutlineKind;
using rheometry::fields::SectionFields;

bool shows_vortex(const SectionFields& section) {
    return section.find(rheometry::fields::name::stream_function) != nullptr;
}

void show_vortex(SectionFields vortex, RowFields& fields) {
    const auto found = std::ranges::find(fields, vortex.row, &SectionFields::row);
    if (found == fields.end()) {
        return;
    }
    for (OutlineEdge& edge : vortex.outline) {
        if (edge.kind == OutlineKind::free_surface) {
            edge.kind = OutlineKind::open_end;
        }
    }
    *found = std::move(vortex);
}

void show_steady_vortex(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                        double speed, const FlowLevel& level, RowFields& fields) {
    const double wall_rate = radial::steady_gap_flow(gap, law, speed).inner_wall_rate;
    for (const SectionFields& laminar : fields) {
        if (std::abs(laminar.speed) == speed) {
            SectionFields vortex = flow_fields(level, level.state().velocity,
                                               {gap.inner_radius, laminar.speed, wall_rate}, law);
            vortex.row = laminar.row;
            vortex.time = laminar.time;
            show_vortex(std::move(vortex), fields);
        }
    }
}

void drop_fields_without_rows(std::size_t rows, RowFields& fields) {
    std::erase_if(fields, [&](const SectionFields& section) { return section.row > rows; });
}

} // namespace searle::solvers::meridional
