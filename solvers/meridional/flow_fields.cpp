#include "solvers/meridional/flow_fields.hpp"

#include "solvers/axisymmetric/swirl_fields.hpp"
#include "solvers/meridional/stream_function.hpp"

#include <utility>

namespace searle::solvers::meridional {

rheometry::fields::SectionFields flow_fields(const FlowLevel& level,
                                             const Eigen::MatrixX3d& velocity,
                                             const FieldScales& scales,
                                             const laws::flow::AnyFlowLaw& law) {
    const Eigen::VectorXd u = velocity.col(static_cast<Eigen::Index>(Component::radial));
    const Eigen::VectorXd w = velocity.col(static_cast<Eigen::Index>(Component::axial));
    const Eigen::VectorXd spin = velocity.col(static_cast<Eigen::Index>(Component::rotation));
    const Eigen::VectorXd stream = stream_function(level.space(), velocity);
    return axisymmetric::swirl_fields({.mesh = level.mesh(),
                                       .length = scales.length,
                                       .degree = level.space().degree(),
                                       .rotation = spin,
                                       .speed = scales.speed,
                                       .rate_scale = scales.wall_rate,
                                       .radial = &u,
                                       .axial = &w,
                                       .stream_function = &stream},
                                      law);
}

std::vector<rheometry::fields::SectionFields>
flow_fields_at_rows(const FlowLevel& level, std::span<const RowVelocity> rows,
                    const FieldScales& scales, const laws::flow::AnyFlowLaw& law,
                    const rheometry::SpeedHistory& history) {
    std::vector<rheometry::fields::SectionFields> sections;
    for (const RowVelocity& each : rows) {
        auto section = flow_fields(level, each.velocity, scales, law);
        section.row = each.row;
        section.time = history.row_times[each.row - 1];
        section.speed = history.speed_at(section.time);
        sections.push_back(std::move(section));
    }
    return sections;
}

} // namespace searle::solvers::meridional
