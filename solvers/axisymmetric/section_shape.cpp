#include "solvers/axisymmetric/section_shape.hpp"

#include "solvers/radial/annular_gap.hpp"

#include <numbers>

namespace searle::solvers::axisymmetric {
namespace {

radial::AnnularGap gap_outside_rotor(const SectionShape& shape) {
    if (const geometry::DinBob* bob = shape.bob()) {
        return {bob->bob_radius, bob->cup_radius};
    }
    return {shape.double_gap()->radii[2], shape.double_gap()->radii[3]};
}

} // namespace

double SectionShape::unit() const {
    return bob() != nullptr ? bob()->bob_radius : double_gap()->radii[2];
}

double SectionShape::endless_torque(const laws::flow::AnyFlowLaw& law, double speed) const {
    if (const geometry::DinBob* one = bob()) {
        return one->height() *
               radial::steady_gap_flow({one->bob_radius, one->cup_radius}, law, speed)
                   .torque_per_length;
    }
    const auto& [post, inside, outside, cup] = double_gap()->radii;
    return double_gap()->height *
           (radial::steady_gap_flow({post, inside}, law, speed).torque_per_length +
            radial::steady_gap_flow({outside, cup}, law, speed).torque_per_length);
}

double SectionShape::gap() const { return gap_outside_rotor(*this).width(); }

double SectionShape::wall_rate(const laws::flow::AnyFlowLaw& law, double speed) const {
    return radial::steady_gap_flow(gap_outside_rotor(*this), law, speed).inner_wall_rate;
}

std::optional<SectionShape> section_shape(const geometry::Instrument& instrument) {
    struct Find {
        std::optional<SectionShape> operator()(const geometry::DinBob& bob) const { return bob; }
        std::optional<SectionShape> operator()(const geometry::ConcentricCylinders& gap) const {
            if (!gap.ends) {
                return std::nullopt;
            }
            return geometry::with_flat_bottom(gap);
        }
        std::optional<SectionShape> operator()(const geometry::DoubleGap& gap) const {
            if (!gap.ends) {
                return std::nullopt;
            }
            return DoubleGapSection{gap.radii, gap.height, gap.bottom_gap};
        }
        std::optional<SectionShape> operator()(const geometry::Box&) const { return std::nullopt; }
    };
    return std::visit(Find{}, instrument);
}

} // namespace searle::solvers::axisymmetric
