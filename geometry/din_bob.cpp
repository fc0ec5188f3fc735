#include "geometry/din_bob.hpp"

#include <cmath>
#include <numbers>

namespace searle::geometry {

double DinBob::cone_height() const { return bob_radius / std::tan(0.5 * cone_angle); }

double DinBob::tip_clearance() const { return bottom_ratio * bob_radius - cone_height(); }

double DinBob::fill_volume() const {
    const double filled_height = (bottom_ratio + length_ratio + top_ratio) * bob_radius;
    const double cup = filled_height * cup_radius * cup_radius;
    const double cone = cone_height() * bob_radius * bob_radius / 3.0;
    const double cylinder = height() * bob_radius * bob_radius;
    const double shaft_radius = shaft_ratio * bob_radius;
    const double shaft = top_ratio * bob_radius * shaft_radius * shaft_radius;
    return std::numbers::pi * (cup - cone - cylinder - shaft);
}

DinBob with_flat_bottom(const ConcentricCylinders& gap) {
    const double radius = gap.bob_radius;
    return {.bob_radius = radius,
            .cup_radius = gap.cup_radius,
            .length_ratio = gap.height / radius,
            .bottom_ratio = gap.bottom_gap / radius,
            .top_ratio = gap.top_gap / radius,
            .shaft_ratio = gap.shaft_radius / radius,
            .cone_angle = std::numbers::pi};
}

} // namespace searle::geometry
