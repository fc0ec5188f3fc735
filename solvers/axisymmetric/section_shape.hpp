#pragma once

#include "geometry/instrument.hpp"
#include "laws/flow/flow_law.hpp"

#include <array>
#include <optional>
#include <variant>

namespace searle::solvers::axisymmetric {

/// A double gap with the fluid under its rotor: the cup is filled to the height of the rotor's
/// wetted length on both sides. z = 0 is the rotor's lower edge.
struct DoubleGapSection {
    std::array<double, 4> radii{}; ///< post, rotor inside, rotor outside, cup, m
    double height{};               ///< m
    double bottom_gap{};           ///< m, between the rotor's lower edge and the floor
};

/// A rotor in its cup with all the fluid around it, ends included.
class SectionShape {
public:
    SectionShape(const geometry::DinBob& bob)
        : shape_(bob) {} // NOLINT(google-explicit-constructor)
    SectionShape(const DoubleGapSection& gap)
        : shape_(gap) {} // NOLINT(google-explicit-constructor)

    [[nodiscard]] const geometry::DinBob* bob() const {
        return std::get_if<geometry::DinBob>(&shape_);
    }
    [[nodiscard]] const DoubleGapSection* double_gap() const {
        return std::get_if<DoubleGapSection>(&shape_);
    }
    /// The length that meshes are scaled with, m: the radius of the bob, of the rotor outside.
    [[nodiscard]] double unit() const;
    /// Width of the gap outside the rotor, m.
    [[nodiscard]] double gap() const;
    /// Torque of the wetted length of an endless instrument at a speed > 0, N m.
    [[nodiscard]] double endless_torque(const laws::flow::AnyFlowLaw& law, double speed) const;
    /// Rate of shear at the rotor's outer wall there, 1/s.
    [[nodiscard]] double wall_rate(const laws::flow::AnyFlowLaw& law, double speed) const;

private:
    std::variant<geometry::DinBob, DoubleGapSection> shape_;
};

/// The section of an instrument that has ends: a DIN bob, and single and double gap with
/// ends = true. A bob of a single gap is a DIN bob with a flat bottom. No value: a slice without
/// ends.
[[nodiscard]] std::optional<SectionShape> section_shape(const geometry::Instrument& instrument);

} // namespace searle::solvers::axisymmetric
